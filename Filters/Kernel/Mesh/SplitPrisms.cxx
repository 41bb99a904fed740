// SPDX-License-Identifier: BSD-3-Clause
#include "SplitPrisms.h"

#include "../Geometry/Predicates.h"
#include "CellFaces.h"

#include <algorithm>
#include <map>
#include <set>

namespace lamina
{
namespace
{

constexpr Id Grain = 8192;
using Tet = std::array<Id, 4>;
using Key = std::array<Id, 4>;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

Key KeyOf(const CellFace& quad)
{
  Key key = quad.corners;
  std::sort(key.begin(), key.end());
  return key;
}

/// How a cell is cut.
enum class Cut : char
{
  Kept,   ///< a tetrahedron
  Fan,    ///< between its own nodes
  Middle, ///< by tetrahedra to a point in its middle
  None    ///< no positive one
};

class Splitter
{
public:
  Splitter(const VolumeMesh& mesh, Monitor& monitor)
    : Mesh(mesh)
    , World(monitor)
    , Cuts(mesh.types.size(), Cut::Kept)
  {
  }

  /// Choose a cut for every cell; the places where there is none.
  std::vector<Vec3> Choose()
  {
    this->World.For(this->Mesh.CellCount(), Grain,
                    [&](Id begin, Id end)
                    {
                      for (Id c = begin; c < end; ++c)
                      {
                        this->Cuts[Index(c)] = this->Best(c);
                      }
                    });
    std::vector<Vec3> places;
    for (Id c = 0; c < this->Mesh.CellCount(); ++c)
    {
      if (this->Cuts[Index(c)] == Cut::None && !this->TurnQuads(c))
      {
        places.push_back(this->Middle(c));
      }
    }
    return places;
  }

  void Fill(VolumeMesh& tets, std::vector<Id>& firstOf)
  {
    const VolumeMesh& mesh = this->Mesh;
    tets.points = mesh.points;
    tets.layerIndex = mesh.layerIndex;
    tets.interfaceNodeIds = mesh.interfaceNodeIds;
    for (Id c = 0; c < mesh.CellCount(); ++c)
    {
      firstOf.push_back(tets.CellCount());
      const int layer = mesh.layers.empty() ? 0 : mesh.layers[Index(c)];
      Id middle = -1;
      if (this->Cuts[Index(c)] == Cut::Middle)
      {
        middle = static_cast<Id>(tets.points.size());
        tets.points.push_back(this->Middle(c));
        if (!tets.layerIndex.empty())
        {
          tets.layerIndex.push_back(-1);
        }
        if (!tets.interfaceNodeIds.empty())
        {
          tets.interfaceNodeIds.push_back(-1);
        }
      }
      for (const Tet& tet : this->TetsOf(c, middle))
      {
        tets.AddCell(CellType::Tetrahedron, tet, mesh.materials[Index(c)], layer);
      }
    }
    firstOf.push_back(tets.CellCount());
  }

  /// The triangles a face is cut into.
  std::vector<Triangle> Triangles(const CellFace& face) const
  {
    const auto& q = face.corners;
    if (!face.IsQuad())
    {
      return { { { q[0], q[1], q[2] } } };
    }
    const auto least = static_cast<std::size_t>(std::min_element(q.begin(), q.end()) - q.begin());
    const bool isTurned = !this->Turned.empty() && this->Turned.count(KeyOf(face)) != 0;
    const std::size_t a = (least + (isTurned ? 1 : 0)) % 4;
    return { { { q[a], q[(a + 1) % 4], q[(a + 2) % 4] } }, { { q[a], q[(a + 2) % 4], q[(a + 3) % 4] } } };
  }

  Id TurnedCount() const { return static_cast<Id>(this->Turned.size()); }
  const std::vector<Cut>& GetCuts() const { return this->Cuts; }

private:
  const Vec3& At(Id node) const { return this->Mesh.points[Index(node)]; }

  Vec3 Middle(Id cell) const
  {
    const int n = NodeCount(this->Mesh.types[Index(cell)]);
    Vec3 sum;
    for (int k = 0; k < n; ++k)
    {
      sum += this->At(this->Mesh.Cell(cell)[k]);
    }
    return sum * (1.0 / n);
  }

  std::vector<Triangle> Boundary(Id cell) const
  {
    std::vector<Triangle> all;
    for (int f = 0; f < FaceCount(this->Mesh.types[Index(cell)]); ++f)
    {
      const auto some = this->Triangles(FaceOf(this->Mesh, cell, f));
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }

  bool IsPositive(const Triangle& t, const Vec3& apex) const
  {
    return Orientation(this->At(t[0]), this->At(t[2]), this->At(t[1]), apex) > 0;
  }

  /// The node from which tetrahedra to the triangles that lack it fill the cell, -1 if there is none: one
  /// through which the diagonals of all its quads go.
  Id FanNode(Id cell, const std::vector<Triangle>& boundary) const
  {
    const bool isWedge = this->Mesh.types[Index(cell)] == CellType::Wedge;
    std::vector<Id> nodes(this->Mesh.Cell(cell), this->Mesh.Cell(cell) + (isWedge ? 6 : 5));
    std::sort(nodes.begin(), nodes.end());
    for (Id node : nodes)
    {
      int count = 0;
      bool isPositive = true;
      for (const Triangle& t : boundary)
      {
        if (std::find(t.begin(), t.end(), node) == t.end())
        {
          ++count;
          isPositive = isPositive && this->IsPositive(t, this->At(node));
        }
      }
      if (isPositive && count == (isWedge ? 3 : 2))
      {
        return node;
      }
    }
    return -1;
  }

  Cut Best(Id cell) const
  {
    if (this->Mesh.types[Index(cell)] == CellType::Tetrahedron)
    {
      return Cut::Kept;
    }
    const auto boundary = this->Boundary(cell);
    if (this->FanNode(cell, boundary) >= 0)
    {
      return Cut::Fan;
    }
    const Vec3 middle = this->Middle(cell);
    const bool isPositive = std::all_of(boundary.begin(), boundary.end(),
                                        [&](const Triangle& t) { return this->IsPositive(t, middle); });
    return isPositive ? Cut::Middle : Cut::None;
  }

  std::vector<Tet> TetsOf(Id cell, Id middle) const
  {
    if (this->Cuts[Index(cell)] == Cut::Kept)
    {
      const Id* n = this->Mesh.Cell(cell);
      return { { { n[0], n[1], n[2], n[3] } } };
    }
    const auto boundary = this->Boundary(cell);
    const Id apex = middle >= 0 ? middle : this->FanNode(cell, boundary);
    std::vector<Tet> tets;
    for (const Triangle& t : boundary)
    {
      if (std::find(t.begin(), t.end(), apex) == t.end())
      {
        tets.push_back({ { t[0], t[2], t[1], apex } });
      }
    }
    return tets;
  }

  /// The cells at each quad, found when first needed.
  const std::vector<Id>& CellsAt(const Key& key)
  {
    if (this->QuadCells.empty())
    {
      for (Id c = 0; c < this->Mesh.CellCount(); ++c)
      {
        for (int f = 0; f < FaceCount(this->Mesh.types[Index(c)]); ++f)
        {
          const CellFace face = FaceOf(this->Mesh, c, f);
          if (face.IsQuad())
          {
            this->QuadCells[KeyOf(face)].push_back(c);
          }
        }
      }
    }
    return this->QuadCells[key];
  }

  /// Turn diagonals of a cell until it and its neighbours have positive cuts.
  bool TurnQuads(Id cell)
  {
    std::vector<Key> quads;
    for (int f = 0; f < FaceCount(this->Mesh.types[Index(cell)]); ++f)
    {
      const CellFace face = FaceOf(this->Mesh, cell, f);
      if (face.IsQuad())
      {
        quads.push_back(KeyOf(face));
      }
    }
    const auto old = this->Turned;
    for (unsigned choice = 1; choice < 1u << quads.size(); ++choice)
    {
      this->Turned = old;
      std::set<Id> touched{ cell };
      for (std::size_t k = 0; k < quads.size(); ++k)
      {
        if ((choice >> k & 1u) != 0)
        {
          if (!this->Turned.insert(quads[k]).second)
          {
            this->Turned.erase(quads[k]);
          }
          const auto& at = this->CellsAt(quads[k]);
          touched.insert(at.begin(), at.end());
        }
      }
      std::map<Id, Cut> cuts;
      for (Id c : touched)
      {
        cuts[c] = this->Best(c);
      }
      const bool isGood = std::all_of(
        cuts.begin(), cuts.end(),
        [&](const auto& cut) {
          return cut.second != Cut::None || (cut.first != cell && this->Cuts[Index(cut.first)] == Cut::None);
        });
      if (isGood)
      {
        for (const auto& cut : cuts)
        {
          this->Cuts[Index(cut.first)] = cut.second;
        }
        return true;
      }
    }
    this->Turned = old;
    return false;
  }

  const VolumeMesh& Mesh;
  Monitor& World;
  std::vector<Cut> Cuts;
  std::set<Key> Turned; ///< quads cut by the other diagonal
  std::map<Key, std::vector<Id>> QuadCells;
};

/// The tetrahedron of `cells` [begin, end) that has the triangle, and its face.
bool FindTriangle(const VolumeMesh& tets, Id begin, Id end, Triangle corners, Id& cell, int& face)
{
  std::sort(corners.begin(), corners.end());
  for (cell = begin; cell < end; ++cell)
  {
    for (face = 0; face < 4; ++face)
    {
      const CellFace own = FaceOf(tets, cell, face);
      Triangle sorted{ { own.corners[0], own.corners[1], own.corners[2] } };
      std::sort(sorted.begin(), sorted.end());
      if (sorted == corners)
      {
        return true;
      }
    }
  }
  return false;
}

void CarryPatches(const VolumeMesh& mesh, const VolumeMesh& tets, const Splitter& splitter,
                  const std::vector<Id>& firstOf, MeshPatches& patches)
{
  std::vector<PatchFace> faces;
  for (MeshPatch& patch : patches.patches)
  {
    patch.faces = 0;
  }
  for (const PatchFace& old : patches.faces)
  {
    const auto own = splitter.Triangles(FaceOf(mesh, old.cell, old.face));
    const auto other = old.otherCell < 0 ? std::vector<Triangle>{}
                                         : splitter.Triangles(FaceOf(mesh, old.otherCell, old.otherFace));
    for (std::size_t k = 0; k < own.size(); ++k)
    {
      PatchFace face = old;
      FindTriangle(tets, firstOf[Index(old.cell)], firstOf[Index(old.cell) + 1], own[k], face.cell,
                   face.face);
      // Interfaces are triangles; a quad between materials has its halves in the same order on both sides
      // only up to a swap, so look for each.
      for (const Triangle& t : other)
      {
        Id cell = -1;
        int local = -1;
        Triangle a = own[k];
        Triangle b = t;
        std::sort(a.begin(), a.end());
        std::sort(b.begin(), b.end());
        const bool isOnlyOne = other.size() == 1;
        if ((isOnlyOne || a == b) && FindTriangle(tets, firstOf[Index(old.otherCell)],
                                                  firstOf[Index(old.otherCell) + 1], t, cell, local))
        {
          face.otherCell = cell;
          face.otherFace = local;
        }
      }
      ++patches.patches[Index(face.patch)].faces;
      faces.push_back(face);
    }
  }
  patches.faces = std::move(faces);
}

} // namespace

Result<SplitPrismsReport> SplitPrisms(const VolumeMesh& mesh, VolumeMesh& tets, MeshPatches* patches,
                                      Monitor& monitor)
{
  monitor.Progress(0, "Choosing diagonals");
  Splitter splitter(mesh, monitor);
  const std::vector<Vec3> places = splitter.Choose();
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  if (!places.empty())
  {
    return Unreachable(
      std::to_string(places.size()) +
        " wedges or pyramids have no positive cut; they are inverted or flat: run Mesh Audit",
      { places.begin(), places.begin() + static_cast<long>(std::min<std::size_t>(3, places.size())) });
  }
  monitor.Progress(0.5, "Making tetrahedra");
  VolumeMesh made;
  std::vector<Id> firstOf;
  splitter.Fill(made, firstOf);
  if (patches != nullptr)
  {
    CarryPatches(mesh, made, splitter, firstOf, *patches);
  }
  SplitPrismsReport report;
  report.splitCells = std::count_if(splitter.GetCuts().begin(), splitter.GetCuts().end(),
                                    [](Cut cut) { return cut != Cut::Kept; });
  report.addedPoints = static_cast<Id>(made.points.size() - mesh.points.size());
  report.turnedQuads = splitter.TurnedCount();
  tets = std::move(made);
  monitor.Progress(1, "Tetrahedra made");
  return report;
}

} // namespace lamina
