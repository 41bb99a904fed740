// SPDX-License-Identifier: BSD-3-Clause
#include "AuditBoundary.h"

#include "../Mesh/Findings.h"
#include "../Search/TriangleTree.h"

#include <algorithm>

namespace lamina
{
namespace
{

constexpr Id Grain = 1024;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

enum Trouble : char
{
  None = 0,
  Gap = 1,
  Hanging = 2
};

/// The boundary as triangles, quads in their two halves.
struct Skin
{
  std::vector<Triangle> triangles;
  std::vector<Id> cells;
  std::vector<Id> nodes; ///< ascending
  double meanEdge = 0;
};

Skin MakeSkin(const VolumeMesh& mesh, const std::vector<CellFace>& boundary)
{
  Skin skin;
  double sum = 0;
  for (const CellFace& face : boundary)
  {
    for (std::size_t k = 1; k < (face.IsQuad() ? 3u : 2u); ++k)
    {
      const Triangle t{ { face.corners[0], face.corners[k], face.corners[k + 1] } };
      skin.triangles.push_back(t);
      skin.cells.push_back(face.cell);
      skin.nodes.insert(skin.nodes.end(), t.begin(), t.end());
      sum += Norm(mesh.points[Index(t[1])] - mesh.points[Index(t[2])]);
    }
  }
  std::sort(skin.nodes.begin(), skin.nodes.end());
  skin.nodes.erase(std::unique(skin.nodes.begin(), skin.nodes.end()), skin.nodes.end());
  skin.meanEdge = skin.triangles.empty() ? 0 : sum / static_cast<double>(skin.triangles.size());
  return skin;
}

/// What is wrong at a node, and the cell of a face it is too near to.
Trouble Judge(const VolumeMesh& mesh, const Skin& skin, const TriangleTree& tree, Id node, double near,
              Id& cell)
{
  const Vec3& p = mesh.points[Index(node)];
  Box box;
  box.Add(p);
  box.Grow(near);
  Trouble worst = None;
  tree.ForOverlaps(box,
                   [&](Id t)
                   {
                     std::array<Vec3, 3> c;
                     double toCorner2 = std::numeric_limits<double>::infinity();
                     for (std::size_t k = 0; k < 3; ++k)
                     {
                       c[k] = mesh.points[Index(skin.triangles[Index(t)][k])];
                       toCorner2 = std::min(toCorner2, Norm2(c[k] - p));
                     }
                     if (toCorner2 == 0)
                     {
                       return true; // its own corner, or one in the same place
                     }
                     Vec3 closest;
                     std::array<double, 3> weights;
                     if (PointTriangleDistance2(p, c[0], c[1], c[2], closest, weights) <= near * near)
                     {
                       const Trouble found = toCorner2 <= 4 * near * near ? Gap : Hanging;
                       if (worst == None || found == Gap)
                       {
                         worst = found;
                         cell = skin.cells[Index(t)];
                       }
                     }
                     return true;
                   });
  return worst;
}

} // namespace

Result<BoundaryAudit> AuditBoundary(const VolumeMesh& mesh, const std::vector<CellFace>& boundary,
                                    double tolerance, std::vector<unsigned char>& flags, Monitor& monitor)
{
  if (!(tolerance > 0 && tolerance < 0.1))
  {
    return InvalidOption("tolerance is " + std::to_string(tolerance) + ", but must be between 0 and 0.1");
  }
  const Skin skin = MakeSkin(mesh, boundary);
  const TriangleTree tree(mesh.points, skin.triangles);
  std::vector<Trouble> troubles(skin.nodes.size(), None);
  std::vector<Id> cells(skin.nodes.size(), -1);
  monitor.For(static_cast<Id>(skin.nodes.size()), Grain,
              [&](Id begin, Id end)
              {
                for (Id i = begin; i < end; ++i)
                {
                  troubles[Index(i)] =
                    Judge(mesh, skin, tree, skin.nodes[Index(i)], tolerance * skin.meanEdge, cells[Index(i)]);
                }
              });
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  Places gaps;
  Places hanging;
  for (std::size_t i = 0; i < troubles.size(); ++i)
  {
    if (troubles[i] != None)
    {
      (troubles[i] == Gap ? gaps : hanging).Add(mesh.points[Index(skin.nodes[i])]);
      flags[Index(cells[i])] |= FlagNonConforming;
    }
  }
  BoundaryAudit audit;
  audit.gapPoints = gaps.GetCount();
  audit.hangingPoints = hanging.GetCount();
  gaps.Tell("nodes lie next to another, but not in its place: there is a gap", audit.findings);
  hanging.Tell("nodes hang on a face or an edge whose corner they are not", audit.findings);
  return audit;
}

} // namespace lamina
