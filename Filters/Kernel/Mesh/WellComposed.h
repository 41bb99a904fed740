// SPDX-License-Identifier: BSD-3-Clause
// Label images between whose voxels a manifold surface can pass.
#pragma once

#include "../Base/Monitor.h"
#include "LabelImage.h"

namespace lamina
{

/// True if the four voxels around a lattice edge, in cyclic order, have a material that touches itself only
/// across the edge (Latecki's critical configuration C1, tested for every label and its complement).
bool IsCriticalEdge(int p0, int p1, int p2, int p3);

/// Indices of the voxels that stand in a critical configuration (C1, or C2: a material, or its complement,
/// that touches itself across a lattice point only). Voxels outside the image count as background.
std::vector<Id> FindCriticalVoxels(const LabelImage& image, Monitor& monitor);

/// Relabel as few voxels as a greedy search needs until no critical configuration is left. Always ends: a
/// voxel that the search cannot settle only climbs in a fixed order of labels. Returns the voxels changed,
/// ascending.
std::vector<Id> MakeWellComposed(LabelImage& image, Monitor& monitor);

} // namespace lamina
