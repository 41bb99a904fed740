// SPDX-License-Identifier: BSD-3-Clause
// The end of a refinement: volumes set back, and what became of the surface.
#pragma once

#include "../Mesh/VolumeCorrection.h"
#include "RefineSurface.h"
#include "StretchField.h"

namespace lamina
{

/// Moves the sheets so that the shells enclose `targets` again. The correction moves points a little: where
/// that makes triangles meet, their points are left out of it.
void RestoreWithoutIntersections(TriangleComplex& surface, const SheetGraph& sheets,
                                 const std::vector<double>& targets, Monitor& monitor);

/// Fills in what the edges and triangles are like. `stretches`: the metric of lengths and qualities, one a
/// point, or none.
void MeasureRefined(const TriangleComplex& surface, const std::vector<Stretch>& stretches,
                    RefineSurfaceReport& report);

} // namespace lamina
