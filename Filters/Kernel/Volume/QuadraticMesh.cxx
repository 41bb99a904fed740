// SPDX-License-Identifier: BSD-3-Clause
#include "QuadraticMesh.h"

#include "../Geometry/QuadraticCells.h"
#include "../Mesh/CellFaces.h"
#include "../Search/TriangleTree.h"

#include <algorithm>

namespace lamina
{
namespace
{

constexpr Id Grain = 4096;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

using Ends = std::array<Id, 2>;

Ends EndsOf(Id a, Id b)
{
  return a < b ? Ends{ { a, b } } : Ends{ { b, a } };
}

class Builder
{
public:
  Builder(const VolumeMesh& mesh, QuadraticNodes& nodes, Monitor& monitor)
    : Mesh(mesh)
    , Nodes(nodes)
    , World(monitor)
  {
  }

  void NumberEdges()
  {
    auto& ends = this->Nodes.ends;
    this->ForEdges([&](Id a, Id b) { ends.push_back(EndsOf(a, b)); });
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    const Id first = static_cast<Id>(this->Mesh.points.size());
    for (const Ends& e : ends)
    {
      this->Nodes.points.push_back(this->Straight(e));
    }
    this->Nodes.connectivity.reserve(this->Mesh.connectivity.size() * 3 / 2);
    this->ForEdges([&](Id a, Id b) { this->Nodes.connectivity.push_back(first + this->Find(a, b)); });
    for (CellType type : this->Mesh.types)
    {
      this->Nodes.offsets.push_back(this->Nodes.offsets.back() + static_cast<Id>(EdgeNodes(type).size()));
    }
  }

  /// Edges that lie in exactly one patch, an interface or a wall, and in no pyramid.
  std::vector<Id> FreeEdges(const MeshPatches& patches) const
  {
    constexpr int none = -1;
    constexpr int several = -2;
    std::vector<int> patchOf(this->Nodes.ends.size(), none);
    for (const PatchFace& face : patches.faces)
    {
      const CellFace corners = FaceOf(this->Mesh, face.cell, face.face);
      const std::size_t n = corners.IsQuad() ? 4 : 3;
      const PatchKind kind = patches.patches[Index(face.patch)].kind;
      const bool isCurved = kind == PatchKind::Interface || kind == PatchKind::Wall;
      for (std::size_t k = 0; k < n; ++k)
      {
        int& patch = patchOf[Index(this->Find(corners.corners[k], corners.corners[(k + 1) % n]))];
        patch =
          isCurved && !corners.IsQuad() && (patch == none || patch == face.patch) ? face.patch : several;
      }
    }
    for (Id c = 0; c < this->Mesh.CellCount(); ++c)
    {
      if (this->Mesh.types[Index(c)] == CellType::Pyramid)
      {
        for (const auto& e : EdgeNodes(CellType::Pyramid))
        {
          patchOf[Index(this->Find(this->Mesh.Cell(c)[e[0]], this->Mesh.Cell(c)[e[1]]))] = several;
        }
      }
    }
    std::vector<Id> edges;
    for (std::size_t e = 0; e < patchOf.size(); ++e)
    {
      if (patchOf[e] >= 0)
      {
        edges.push_back(static_cast<Id>(e));
      }
    }
    return edges;
  }

  void Project(const std::vector<Id>& edges, const TriangleComplex& surface,
               const QuadraticMeshOptions& options)
  {
    std::vector<Vec3> points = surface.points;
    for (Vec3& p : points)
    {
      p *= options.surfaceScale;
    }
    const TriangleTree tree(points, surface.triangles);
    this->World.For(static_cast<Id>(edges.size()), Grain,
                    [&](Id begin, Id end)
                    {
                      for (Id i = begin; i < end; ++i)
                      {
                        Vec3& node = this->Nodes.points[Index(edges[Index(i)])];
                        const Ends& e = this->Nodes.ends[Index(edges[Index(i)])];
                        const double limit = options.largestOffset * Norm(this->At(e[1]) - this->At(e[0]));
                        const auto closest = tree.ClosestPoint(node, limit * limit);
                        node = closest.triangle >= 0 ? closest.point : node;
                      }
                    });
  }

  /// Straighten the edges of cells that are not valid, until all are.
  Id Relax()
  {
    Id straightened = 0;
    std::vector<char> isBad(this->Mesh.types.size(), 0);
    for (bool isDone = false; !isDone && !this->World.Cancelled();)
    {
      this->World.For(this->Mesh.CellCount(), Grain,
                      [&](Id begin, Id end)
                      {
                        for (Id c = begin; c < end; ++c)
                        {
                          isBad[Index(c)] = this->IsCurved(c) && !this->IsValid(c);
                        }
                      });
      isDone = true;
      for (Id c = 0; c < this->Mesh.CellCount(); ++c)
      {
        for (Id i = this->Nodes.offsets[Index(c)];
             isBad[Index(c)] != 0 && i < this->Nodes.offsets[Index(c) + 1]; ++i)
        {
          const std::size_t e = this->EdgeAt(i);
          const Vec3 straight = this->Straight(this->Nodes.ends[e]);
          if (!(this->Nodes.points[e] == straight))
          {
            this->Nodes.points[e] = straight;
            ++straightened;
            isDone = false;
          }
        }
      }
    }
    return straightened;
  }

  Id CurvedCount() const
  {
    Id count = 0;
    for (std::size_t e = 0; e < this->Nodes.ends.size(); ++e)
    {
      count += !(this->Nodes.points[e] == this->Straight(this->Nodes.ends[e]));
    }
    return count;
  }

private:
  const Vec3& At(Id p) const { return this->Mesh.points[Index(p)]; }
  Vec3 Straight(const Ends& e) const { return 0.5 * (this->At(e[0]) + this->At(e[1])); }
  std::size_t EdgeAt(Id i) const
  {
    return Index(this->Nodes.connectivity[Index(i)]) - this->Mesh.points.size();
  }

  template<typename Visit>
  void ForEdges(Visit&& visit) const
  {
    for (Id c = 0; c < this->Mesh.CellCount(); ++c)
    {
      const Id* cell = this->Mesh.Cell(c);
      for (const auto& e : EdgeNodes(this->Mesh.types[Index(c)]))
      {
        visit(cell[e[0]], cell[e[1]]);
      }
    }
  }

  Id Find(Id a, Id b) const
  {
    const auto& ends = this->Nodes.ends;
    return std::lower_bound(ends.begin(), ends.end(), EndsOf(a, b)) - ends.begin();
  }

  bool IsCurved(Id c) const
  {
    for (Id i = this->Nodes.offsets[Index(c)]; i < this->Nodes.offsets[Index(c) + 1]; ++i)
    {
      const std::size_t e = this->EdgeAt(i);
      if (!(this->Nodes.points[e] == this->Straight(this->Nodes.ends[e])))
      {
        return true;
      }
    }
    return false;
  }

  template<std::size_t N>
  std::array<Vec3, N> CellNodes(Id c, std::size_t corners) const
  {
    std::array<Vec3, N> nodes;
    for (std::size_t k = 0; k < N; ++k)
    {
      nodes[k] =
        k < corners
          ? this->At(this->Mesh.Cell(c)[k])
          : this->Nodes.points[this->EdgeAt(this->Nodes.offsets[Index(c)] + static_cast<Id>(k - corners))];
    }
    return nodes;
  }

  bool IsValid(Id c) const
  {
    switch (this->Mesh.types[Index(c)])
    {
      case CellType::Tetrahedron:
        return QuadraticTetIsValid(this->CellNodes<10>(c, 4));
      case CellType::Wedge:
        return QuadraticWedgeIsValid(this->CellNodes<15>(c, 6));
      default:
        return false;
    }
  }

  const VolumeMesh& Mesh;
  QuadraticNodes& Nodes;
  Monitor& World;
};

} // namespace

Result<QuadraticMeshReport> AddMiddleNodes(const VolumeMesh& mesh, const MeshPatches& patches,
                                           const TriangleComplex* surface,
                                           const QuadraticMeshOptions& options, QuadraticNodes& nodes,
                                           Monitor& monitor)
{
  if (!(options.surfaceScale > 0 && std::isfinite(options.surfaceScale)))
  {
    return InvalidOption("surfaceScale must be above 0");
  }
  if (!(options.largestOffset >= 0 && options.largestOffset <= 0.5))
  {
    return InvalidOption("largestOffset is " + std::to_string(options.largestOffset) +
                         ", but must be from 0 to 0.5");
  }
  QuadraticNodes made;
  QuadraticMeshReport report;
  Builder builder(mesh, made, monitor);
  monitor.Progress(0, "Numbering the edges");
  builder.NumberEdges();
  if (surface != nullptr && !surface->triangles.empty())
  {
    monitor.Progress(0.5, "Moving nodes to the surface");
    builder.Project(builder.FreeEdges(patches), *surface, options);
    monitor.Progress(0.7, "Testing Jacobians");
    report.straightenedEdges = builder.Relax();
    report.curvedEdges = builder.CurvedCount();
  }
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  report.middleNodes = static_cast<Id>(made.points.size());
  nodes = std::move(made);
  monitor.Progress(1, "Middle nodes added");
  return report;
}

} // namespace lamina
