// SPDX-License-Identifier: BSD-3-Clause
// Nodes in the middle of the edges, on the smoothed surface where the cells stay valid.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/MeshPatches.h"
#include "../Mesh/TriangleComplex.h"
#include "../Mesh/VolumeMesh.h"

namespace lamina
{

struct QuadraticMeshOptions
{
  double surfaceScale = 1;     ///< factor on the surface's coordinates to match the mesh, > 0
  double largestOffset = 0.25; ///< farthest a node may move from its edge's middle, in edge lengths, 0 to 0.5
};

struct QuadraticMeshReport
{
  Id middleNodes = 0;
  Id curvedEdges = 0;       ///< whose node lies on the surface, off the edge's middle
  Id straightenedEdges = 0; ///< whose node went back, as a cell would not have been valid
};

/// The nodes to add to a mesh's own, and which of them each cell has, in VTK's order of edges.
struct QuadraticNodes
{
  std::vector<Vec3> points; ///< node mesh.points.size() + i
  std::vector<Id> offsets{ 0 };
  std::vector<Id> connectivity;        ///< a cell's middles, after its own corners
  std::vector<std::array<Id, 2>> ends; ///< of the edge of each added node
};

/// Give every edge a node in its middle. With `surface` (may be null) the nodes of edges on one interface or
/// wall patch (not on its rim, not of a pyramid) go to the closest point of the surface. Cells of which a
/// Bernstein coefficient of the Jacobian is not positive get their edges straightened, until none is left:
/// a cell with straight edges is as valid as the linear one.
Result<QuadraticMeshReport> AddMiddleNodes(const VolumeMesh& mesh, const MeshPatches& patches,
                                           const TriangleComplex* surface,
                                           const QuadraticMeshOptions& options, QuadraticNodes& nodes,
                                           Monitor& monitor);

} // namespace lamina
