// SPDX-License-Identifier: BSD-3-Clause
#include "AuditPatches.h"

#include "CellFaces.h"
#include "Findings.h"
#include "PieceOrder.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace lamina
{
namespace
{

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

using Key = std::pair<Id, int>; // a cell and its face

Vec3 PlaceOf(const VolumeMesh& mesh, const PatchFace& face)
{
  return mesh.points[Index(FaceOf(mesh, face.cell, face.face).corners[0])];
}

class Auditor
{
public:
  Auditor(const VolumeMesh& mesh, const MeshPatches& patches, std::vector<unsigned char>& flags)
    : Mesh(mesh)
    , Patches(patches)
    , Flags(flags)
  {
  }

  PatchAudit Run(const MeshPatches& anew, bool isSure)
  {
    this->ReadTruth(anew, isSure);
    for (const PatchFace& face : this->Patches.faces)
    {
      this->TestFace(face);
    }
    for (const auto& [key, due] : this->Due)
    {
      if (due.count == 0)
      {
        this->Missing.Add(this->Mesh.points[Index(FaceOf(this->Mesh, key.first, key.second).corners[0])]);
        this->Flags[Index(key.first)] |= FlagNonConforming;
      }
    }
    if (this->Wrong.GetCount() == 0)
    {
      this->TestClosedness();
      this->TestPieces();
      this->TestOrder();
    }
    this->Tell();
    return this->Audit;
  }

private:
  struct DueFace
  {
    int count = 0; ///< how often the patches have it
    PatchKind kind = PatchKind::Wall;
    int patch = -1; ///< of the truth
  };

  void ReadTruth(const MeshPatches& truth, bool isSure)
  {
    this->IsSure = isSure;
    for (const PatchFace& face : truth.faces)
    {
      this->Due[{ face.cell, face.face }] = { 0, truth.patches[Index(face.patch)].kind, face.patch };
    }
  }

  void TestFace(const PatchFace& face)
  {
    const bool isPatch = face.patch >= 0 && Index(face.patch) < this->Patches.patches.size();
    const auto due = this->Due.find({ face.cell, face.face });
    if (!isPatch || due == this->Due.end())
    {
      const bool isCell = face.cell >= 0 && face.cell < this->Mesh.CellCount();
      this->Wrong.Add(isCell ? this->Mesh.points[Index(this->Mesh.Cell(face.cell)[0])] : Vec3{});
      return;
    }
    const MeshPatch& patch = this->Patches.patches[Index(face.patch)];
    const PatchKind kind = due->second.kind;
    const bool isInner = kind == PatchKind::Interface;
    // Without the surface, walls cannot be told from plane ends.
    const bool fitsKind = this->IsSure ? patch.kind == kind : (patch.kind == PatchKind::Interface) == isInner;
    const int other = face.otherCell >= 0 && face.otherCell < this->Mesh.CellCount()
                        ? this->Mesh.materials[Index(face.otherCell)]
                        : 0;
    if (!fitsKind || this->Mesh.materials[Index(face.cell)] != patch.pair.first ||
        (isInner && other != patch.pair.second))
    {
      this->Wrong.Add(PlaceOf(this->Mesh, face));
      this->Flags[Index(face.cell)] |= FlagNonConforming;
    }
    if (++due->second.count == 2)
    {
      this->Repeated.Add(PlaceOf(this->Mesh, face));
    }
  }

  /// Round each material the patches' faces run through every edge as often one way as the other.
  void TestClosedness()
  {
    struct Edge
    {
      int material;
      Id low;
      Id high;
      int sense;
    };
    std::vector<Edge> edges;
    for (const PatchFace& face : this->Patches.faces)
    {
      const CellFace corners = FaceOf(this->Mesh, face.cell, face.face);
      const MeshPatch& patch = this->Patches.patches[Index(face.patch)];
      const std::size_t n = corners.IsQuad() ? 4 : 3;
      for (std::size_t k = 0; k < n; ++k)
      {
        const Id a = corners.corners[k];
        const Id b = corners.corners[(k + 1) % n];
        const int sense = a < b ? 1 : -1;
        edges.push_back({ patch.pair.first, std::min(a, b), std::max(a, b), sense });
        if (patch.kind == PatchKind::Interface)
        {
          edges.push_back({ patch.pair.second, std::min(a, b), std::max(a, b), -sense });
        }
      }
    }
    const auto key = [](const Edge& e) { return std::tie(e.material, e.low, e.high); };
    std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < edges.size();)
    {
      int sum = 0;
      std::size_t j = i;
      for (; j < edges.size() && key(edges[j]) == key(edges[i]); ++j)
      {
        sum += edges[j].sense;
      }
      if (sum != 0)
      {
        this->Open.Add(this->Mesh.points[Index(edges[i].low)]);
      }
      i = j;
    }
  }

  /// With the truth at hand, each patch is one of its, and each of its is one patch. Plane ends are plane.
  void TestPieces()
  {
    std::map<int, std::set<int>> oursOf;
    std::map<int, std::set<int>> truthOf;
    for (const PatchFace& face : this->Patches.faces)
    {
      const int patch = this->Due.at({ face.cell, face.face }).patch;
      oursOf[patch].insert(face.patch);
      truthOf[face.patch].insert(patch);
    }
    for (const auto& [patch, others] : truthOf)
    {
      if (others.size() > 1)
      {
        this->Swap(patch, "has faces of " + std::to_string(others.size()) + " separate pieces");
      }
    }
    for (const auto& [patch, ours] : oursOf)
    {
      if (this->IsSure && ours.size() > 1)
      {
        this->Swap(*ours.begin(), "and others share one connected piece");
      }
    }
    this->TestPlanes();
  }

  void TestPlanes()
  {
    for (std::size_t p = 0; p < this->Patches.patches.size(); ++p)
    {
      const PatchKind kind = this->Patches.patches[p].kind;
      if (kind != PatchKind::Border && kind != PatchKind::Opening)
      {
        continue;
      }
      Vec3 normal;
      Vec3 origin;
      double extent = 0;
      double away = 0;
      for (int pass = 0; pass < 2; ++pass)
      {
        for (const PatchFace& face : this->Patches.faces)
        {
          if (face.patch != static_cast<int>(p))
          {
            continue;
          }
          const CellFace corners = FaceOf(this->Mesh, face.cell, face.face);
          const Vec3& a = this->Mesh.points[Index(corners.corners[0])];
          if (pass == 0)
          {
            origin = a;
            normal += Cross(this->Mesh.points[Index(corners.corners[1])] - a,
                            this->Mesh.points[Index(corners.corners[2])] - a);
          }
          away = std::max(away, std::abs(Dot(a - origin, normal)));
          extent = std::max(extent, Norm(a - origin));
        }
        away = pass == 0 ? 0 : away;
        normal = Normalized(normal);
      }
      if (away > 1e-6 * extent)
      {
        this->Swap(static_cast<int>(p), "is not plane, as an end is");
      }
    }
  }

  /// The patches of a kind and pair of materials stand in the order of their sizes and places.
  void TestOrder()
  {
    const auto& patches = this->Patches.patches;
    std::vector<Piece> pieces(patches.size());
    for (const PatchFace& face : this->Patches.faces)
    {
      const CellFace c = FaceOf(this->Mesh, face.cell, face.face);
      const auto at = [&](std::size_t k) { return this->Mesh.points[Index(c.corners[k])]; };
      for (std::size_t k = 1; k < (c.IsQuad() ? 3u : 2u); ++k)
      {
        const double area = 0.5 * Norm(Cross(at(k) - at(0), at(k + 1) - at(0)));
        pieces[Index(face.patch)].size += area;
        pieces[Index(face.patch)].centre += (at(0) + at(k) + at(k + 1)) * (area / 3);
      }
    }
    for (std::size_t begin = 0; begin < patches.size();)
    {
      std::size_t end = begin;
      std::vector<Piece> family;
      for (; end < patches.size() && patches[end].kind == patches[begin].kind &&
             patches[end].pair == patches[begin].pair;
           ++end)
      {
        family.push_back(pieces[end]);
        family.back().centre *= family.back().size > 0 ? 1 / family.back().size : 0;
      }
      const auto order = OrderPieces(family, ExtentOf(this->Mesh.points));
      for (std::size_t k = 0; k < order.size(); ++k)
      {
        if (order[k] != k)
        {
          this->Swap(static_cast<int>(begin + k),
                     "and " + patches[begin + order[k]].name + " stand in the wrong order: they are swapped");
          break; // those that follow are out of order for the same reason
        }
      }
      begin = end;
    }
  }

  void Swap(int patch, const std::string& what)
  {
    ++this->Audit.swappedPatches;
    this->Audit.findings.push_back("the patch " + this->Patches.patches[Index(patch)].name + " " + what);
  }

  void Tell()
  {
    this->Audit.wrongFaces = this->Wrong.GetCount();
    this->Audit.missingFaces = this->Missing.GetCount();
    this->Audit.repeatedFaces = this->Repeated.GetCount();
    this->Audit.openEdges = this->Open.GetCount();
    auto& findings = this->Audit.findings;
    this->Wrong.Tell("faces of patches are not what their patch says: a patch is swapped, or of other cells",
                     findings);
    this->Missing.Tell("faces of the boundary or between materials are in no patch", findings);
    this->Repeated.Tell("faces are in more than one patch", findings);
    this->Open.Tell("edges where the patches round a material do not close", findings);
  }

  const VolumeMesh& Mesh;
  const MeshPatches& Patches;
  std::vector<unsigned char>& Flags;
  bool IsSure = false;
  std::map<Key, DueFace> Due;
  Places Wrong;
  Places Missing;
  Places Repeated;
  Places Open;
  PatchAudit Audit;
};

} // namespace

PatchAudit AuditPatches(const VolumeMesh& mesh, const MeshPatches& patches, const MeshPatches& anew,
                        bool isSure, std::vector<unsigned char>& flags)
{
  return Auditor(mesh, patches, flags).Run(anew, isSure);
}

} // namespace lamina
