// SPDX-License-Identifier: BSD-3-Clause
// Plane ends where a material reaches the edge of the region of interest.
#pragma once

#include "../Mesh/LabelImage.h"

#include <vector>

namespace lamina
{

/// Where one of `materials` meets the mask's edge (a background voxel outside the mask), cut it by an
/// axis-aligned plane, so that the opening there is plane: what is beyond becomes background. Every connected
/// contact is cut along the axis in which it faces outside most, just inside its deepest voxel. A cut that
/// would take more than a fifth of its material is left out (the contact is no vessel's end), and the contact
/// stays a wall. Returns a flag a voxel: 1 where a cut took it; empty if there was none.
std::vector<char> CutMaterialsAtMask(LabelImage& labels, const LabelImage& mask,
                                     const std::vector<int>& materials);

} // namespace lamina
