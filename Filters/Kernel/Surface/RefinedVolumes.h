// SPDX-License-Identifier: BSD-3-Clause
// The volumes of a refined surface set back to those of the input.
#pragma once

#include "InputSurface.h"

namespace lamina
{

/// Moves the sheets so that every shell encloses its volume of `targets` again. No point goes farther than
/// the tolerance allows, none is hidden by it, no triangle gets bad and nothing intersects for it: where a
/// move does such a thing, points there move less and others more. What a small shell cannot regain within
/// that, the largest shell of its material takes over, so that the materials have their volumes. `sheets` are
/// those of the surface's triangles, in the numbers of the input.
void RestoreRefinedVolumes(TriangleComplex& surface, const SheetGraph& sheets,
                           const std::vector<double>& targets, const InputSurface& input, Monitor& monitor);

} // namespace lamina
