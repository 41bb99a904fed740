// SPDX-License-Identifier: BSD-3-Clause
// Edge-only and corner-only contacts between voxels of one material, closed by filling with another.
#pragma once

#include "../Mesh/LabelImage.h"

namespace lamina
{

/// Turn voxels into `filler` until no 2x2x2 block holds a material (of those other than filler, or filler
/// itself) that meets itself in an edge or a corner only. Only ever adds filler, so it ends. Returns the
/// voxels changed.
Id MendContacts(LabelImage& image, int filler);

/// The number of 2x2x2 blocks with such a contact.
Id CountContacts(const LabelImage& image);

} // namespace lamina
