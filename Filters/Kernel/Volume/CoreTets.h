// SPDX-License-Identifier: BSD-3-Clause
// Tetrahedra inside closed surfaces, no point added on them: constrained Delaunay by TetGen in a child
// process.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/TriangleComplex.h"
#include "../Mesh/VolumeMesh.h"

#include <string>

namespace lamina
{

struct CoreTetsOptions
{
  std::string program;          ///< path of lamina-tetgen; empty: TetGen runs inside this process
  double radiusEdgeRatio = 1.4; ///< TetGen's -q: largest circumradius over shortest edge, >= 1.2
  double sizeFactor =
    1.3; ///< with maximumEdge, tets may be this much longer than the surface's edges near them
  double maximumEdge =
    0; ///< longest edge wanted in the core, a length; 0: sizes grow as the ratio above allows
  /// What nothing else betters is worked on by force (ImproveStuck.h), and at last oblique and skew faces
  /// between cells are (ImproveFaces.h). In vain where the cells are improved further, with others.
  bool isThorough = false;
};

struct CoreTetsReport
{
  Id tets = 0;
  Id addedPoints = 0;
  int rung = 1; ///< 1: as asked; or, where TetGen failed, 2: without points that grade sizes, 3: besides with
                ///< a radius-edge ratio of 2, 4: besides without refinement
  double leastQuality = 0;            ///< least 3r/R
  double aboveGate = 1;               ///< share of tets with 3r/R > 0.1
  std::vector<Id> offendingTriangles; ///< of `surface`, when TetGen refuses it
};

/// Fill the inside of `surface` (one or many closed pieces, cavities allowed; each material by its
/// MaterialPair) with tetrahedra. `interiorPoints` are inserted if they lie inside. The first points of
/// `mesh` are those of `surface`, in order and bit for bit. On failure `report` (if given) tells the
/// offending triangles.
Result<CoreTetsReport> MeshCoreTets(const TriangleComplex& surface, const std::vector<Vec3>& interiorPoints,
                                    const CoreTetsOptions& options, VolumeMesh& mesh, Monitor& monitor,
                                    CoreTetsReport* onFailure = nullptr);

} // namespace lamina
