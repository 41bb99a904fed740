// SPDX-License-Identifier: BSD-3-Clause
#include "GapFloors.h"

#include "../Search/SheetGaps.h"

#include <algorithm>

namespace lamina
{

namespace
{

constexpr double leastGap = 0.25; ///< in voxels
constexpr double leastShareOfGap = 0.5;
/// An upper bound of a smoothed surface's voxels, in its mean edges.
constexpr double voxelPerMeanEdge = 1.1;
/// Targets count up to this many mean edges: the gaps of far sheets need not be known.
constexpr double mostMeanEdges = 4;

} // namespace

std::vector<double> FindGapFloors(const TriangleComplex& surface, double meanEdge, Monitor& monitor)
{
  const bool isSingle = MaterialsOf(surface).size() == 1;
  const double voxel = voxelPerMeanEdge * meanEdge;
  std::vector<double> floors;
  for (const double target : surface.targetEdgeLength)
  {
    floors.push_back(leastGap * (isSingle ? std::clamp(target, voxel, mostMeanEdges * meanEdge) : voxel));
  }
  if (floors.empty())
  {
    return floors;
  }
  const double cutoff = *std::max_element(floors.begin(), floors.end()) / leastShareOfGap;
  const SheetGaps gaps = MeasureGaps(
    surface.points, surface.triangles, MakeEdgeTable(surface.triangles),
    TrianglesOfPoints(static_cast<Id>(surface.points.size()), surface.triangles), cutoff, monitor);
  for (std::size_t p = 0; p < floors.size(); ++p)
  {
    floors[p] = std::min(floors[p], leastShareOfGap * gaps.facing[p]);
  }
  return floors;
}

} // namespace lamina
