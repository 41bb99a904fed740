// SPDX-License-Identifier: BSD-3-Clause
// How near to each other refinement may bring triangles that face each other.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/TriangleComplex.h"

namespace lamina
{

/// The least angle between triangles that share an edge, in degrees: edits bring none below it.
constexpr double LeastFold = 10;

/// Per point of a surface the least distance to what faces it (see SheetGaps) that edits there may leave: a
/// quarter of a voxel, of which the mean edge tells the size, or half of what it is if that is less. Around a
/// single material there may never have been voxels: a target edge length that is larger takes their place.
std::vector<double> FindGapFloors(const TriangleComplex& surface, double meanEdge, Monitor& monitor);

} // namespace lamina
