// SPDX-License-Identifier: BSD-3-Clause
// How deep points lie in a wall, from one of its sides to the other, and the direction across it.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/MeshPatches.h"
#include "../Mesh/VolumeMesh.h"

namespace lamina
{

struct WallDepthOptions
{
  std::vector<int> materials{ 1 }; ///< that make up the wall
  /// Names of patches or pairs of materials ("1-2"); empty: all interfaces of the materials.
  std::vector<std::string> inner;
  std::vector<std::string> outer; ///< empty: all their outer walls
};

struct WallDepthReport
{
  Id cells = 0;          ///< with a depth
  Id oneSided = 0;       ///< cells of the materials where there is no second wall
  Id contestedNodes = 0; ///< points on both walls: half way
  int iterations = 0;    ///< of the solver
};

struct WallDepthField
{
  std::vector<double> points; ///< 0 inner wall, 1 outer wall, -1 elsewhere
  std::vector<double> cells;  ///< the same at the cells' middles
  std::vector<Vec3> normals;  ///< one a cell: of length 1, from the inner to the outer wall; or zero
};

/// Solves Laplace's equation on the cells of the materials, 0 on the inner wall, 1 on the outer, no flux
/// through the rest of the boundary (vessels in the wall, ends), by linear finite elements. No depth have
/// pieces that lack one of the walls, and parts that stand out from one wall so far that nothing of the other
/// is felt (chordae, trabeculae): there the depth is less than a twentieth of what the distances say. Of a
/// wedge or pyramid the mean of its two splits into tetrahedra by opposite diagonals counts, so that
/// neighbours agree.
Result<WallDepthReport> ComputeWallDepth(const VolumeMesh& mesh, const MeshPatches& patches,
                                         const WallDepthOptions& options, WallDepthField& field,
                                         Monitor& monitor);

} // namespace lamina
