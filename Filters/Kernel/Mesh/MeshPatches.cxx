// SPDX-License-Identifier: BSD-3-Clause
#include "MeshPatches.h"

#include "Adjacency.h"
#include "CellFaces.h"
#include "Openings.h"
#include "PieceOrder.h"
#include "PointTable.h"

#include <algorithm>
#include <limits>
#include <numeric>
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

/// What faces of one patch share before pieces are told apart.
struct Group
{
  PatchKind kind = PatchKind::Wall;
  MaterialPair pair;
  int surfacePatch = 0;
};
bool operator<(const Group& a, const Group& b)
{
  return std::tie(a.kind, a.pair.first, a.pair.second, a.surfacePatch) <
         std::tie(b.kind, b.pair.first, b.pair.second, b.surfacePatch);
}
bool operator==(const Group& a, const Group& b)
{
  return !(a < b) && !(b < a);
}

struct RawFace
{
  PatchFace face;
  std::array<Id, 4> corners;
  Group group;
};

/// Sets of faces that are connected through edges.
class Unions
{
public:
  explicit Unions(std::size_t count)
    : Parent(count)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), std::size_t{ 0 });
  }
  std::size_t Root(std::size_t i)
  {
    while (this->Parent[i] != i)
    {
      i = this->Parent[i] = this->Parent[this->Parent[i]];
    }
    return i;
  }
  void Join(std::size_t a, std::size_t b)
  {
    const std::size_t ra = this->Root(a);
    const std::size_t rb = this->Root(b);
    this->Parent[std::max(ra, rb)] = std::min(ra, rb);
  }

private:
  std::vector<std::size_t> Parent;
};

/// For each group of faces the patch of the surface's triangle it is, 0 for a wall or none.
std::vector<int> MatchSurface(const VolumeMesh& mesh, const TriangleComplex& surface, double scale,
                              const CellFaces& faces)
{
  std::vector<int> patchOf(faces.GroupCount(), 0);
  PointTable table(mesh.points.size());
  std::vector<Id> idOf;
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    if (Index(table.Insert(mesh.points[p])) == idOf.size())
    {
      idOf.push_back(static_cast<Id>(p));
    }
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (surface.Patch(static_cast<Id>(t)) == 0)
    {
      continue;
    }
    Triangle corners = surface.triangles[t];
    bool isThere = true;
    for (Id& corner : corners)
    {
      const Id found = table.Find(surface.points[Index(corner)] * scale);
      isThere = isThere && found >= 0;
      corner = found < 0 ? -1 : idOf[Index(found)];
    }
    const Id group = isThere ? faces.Find(corners) : -1;
    if (group >= 0)
    {
      patchOf[Index(group)] = surface.Patch(static_cast<Id>(t));
    }
  }
  return patchOf;
}

/// The faces that belong to a patch: those of one cell, and those of two cells of different materials.
std::vector<RawFace> CollectFaces(const VolumeMesh& mesh, const TriangleComplex* surface, double scale,
                                  const CellFaces* known, Monitor& monitor)
{
  const CellFaces own = known != nullptr ? CellFaces{} : FindCellFaces(mesh, monitor);
  const CellFaces& all = known != nullptr ? *known : own;
  const Openings openings(surface, scale);
  const std::vector<int> patchOf =
    surface != nullptr ? MatchSurface(mesh, *surface, scale, all) : std::vector<int>{};
  const auto material = [&](const CellFace& face) { return mesh.materials[Index(face.cell)]; };
  std::vector<RawFace> faces;
  for (std::size_t g = 0; g < all.GroupCount(); ++g)
  {
    const CellFace* face = all.faces.data() + all.start[g];
    const std::size_t size = all.start[g + 1] - all.start[g];
    if (size > 2 || (size == 2 && material(face[0]) == material(face[1])))
    {
      continue;
    }
    const bool isSwapped = size == 2 && material(face[1]) < material(face[0]);
    const CellFace& first = face[isSwapped ? 1 : 0];
    RawFace raw;
    raw.corners = first.corners;
    raw.face.cell = first.cell;
    raw.face.face = LocalFace(mesh, first);
    raw.group.pair = { material(first), 0 };
    if (size == 2)
    {
      const CellFace& second = face[isSwapped ? 0 : 1];
      raw.face.otherCell = second.cell;
      raw.face.otherFace = LocalFace(mesh, second);
      raw.group.pair.second = material(second);
      raw.group.kind = PatchKind::Interface;
    }
    else if (surface != nullptr)
    {
      const int marked = patchOf[g];
      const bool isOpening = IsOpening(*surface, marked);
      const int opening = marked != 0 && !isOpening ? 0 : openings.Find(mesh, first, marked);
      raw.group.surfacePatch = opening != 0 ? opening : marked;
      raw.group.kind =
        opening != 0 || isOpening ? PatchKind::Opening : (marked != 0 ? PatchKind::Border : PatchKind::Wall);
    }
    faces.push_back(raw);
  }
  return faces;
}

/// The piece of each face: faces of one group that are connected through edges; pieces are numbered in the
/// order of their first face.
std::vector<std::size_t> FindPieces(const std::vector<RawFace>& faces, std::size_t& count)
{
  struct Side
  {
    Id low;
    Id high;
    std::size_t face;
  };
  std::vector<Side> sides;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const std::size_t n = faces[f].corners[3] < 0 ? 3 : 4;
    for (std::size_t k = 0; k < n; ++k)
    {
      const auto ends = std::minmax(faces[f].corners[k], faces[f].corners[(k + 1) % n]);
      sides.push_back({ ends.first, ends.second, f });
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b)
            { return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face); });
  Unions unions(faces.size());
  for (std::size_t begin = 0; begin < sides.size();)
  {
    std::size_t end = begin + 1;
    while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high)
    {
      ++end;
    }
    for (std::size_t a = begin; a < end; ++a)
    {
      for (std::size_t b = a + 1; b < end; ++b)
      {
        if (faces[sides[a].face].group == faces[sides[b].face].group)
        {
          unions.Join(sides[a].face, sides[b].face);
        }
      }
    }
    begin = end;
  }
  std::map<std::size_t, std::size_t> numbers;
  std::vector<std::size_t> pieces(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    pieces[f] = numbers.emplace(unions.Root(f), numbers.size()).first->second;
  }
  count = numbers.size();
  return pieces;
}

void Measure(const VolumeMesh& mesh, const RawFace& face, MeshPatch& patch)
{
  const auto at = [&](std::size_t k) { return mesh.points[Index(face.corners[k])]; };
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c)
  {
    const double area = 0.5 * Norm(Cross(b - a, c - a));
    patch.area += area;
    patch.centre += (a + b + c) * (area / 3);
  };
  add(at(0), at(1), at(2));
  if (face.corners[3] >= 0)
  {
    add(at(0), at(2), at(3));
  }
  ++patch.faces;
}

/// Gives materials and patches their names, and remembers what was asked for in vain.
class Naming
{
public:
  Naming(const std::map<std::string, std::string>& names, FindPatchesReport& report)
    : Names(names)
    , Report(report)
  {
  }
  /// The name to use instead of `own`.
  std::string Replace(const std::string& own)
  {
    const auto found = this->Names.find(own);
    if (found == this->Names.end())
    {
      return own;
    }
    this->Used.insert(own);
    return found->second;
  }
  std::string Name(const MeshPatch& patch, std::size_t number, const std::map<int, std::string>& materials)
  {
    const auto short_ = [&](int material)
    {
      const auto found = materials.find(material);
      return found == materials.end() ? std::to_string(material) : found->second;
    };
    const char* const kinds[] = { "interface", "wall", "border", "opening" };
    std::string name = std::string(kinds[static_cast<int>(patch.kind)]) + "_" + short_(patch.pair.first);
    if (patch.kind == PatchKind::Interface)
    {
      name += "_" + short_(patch.pair.second);
    }
    name = this->Replace(name + "_" + std::to_string(number));
    std::string unique = name;
    for (int n = 2; !this->Taken.insert(unique).second; ++n)
    {
      unique = name + "_" + std::to_string(n);
    }
    return unique;
  }
  void Close()
  {
    for (const auto& entry : this->Names)
    {
      if (this->Used.count(entry.first) == 0)
      {
        this->Report.unusedNames.push_back(entry.first);
      }
    }
  }

private:
  const std::map<std::string, std::string>& Names;
  FindPatchesReport& Report;
  std::set<std::string> Used;
  std::set<std::string> Taken;
};

/// The patches in their final order, named; `rank` gets each piece's place in it.
std::vector<MeshPatch> NamePatches(std::vector<MeshPatch> pieces, double extent,
                                   const std::map<int, std::string>& materials, Naming& naming,
                                   std::vector<int>& rank)
{
  std::map<std::tuple<PatchKind, int, int>, std::vector<std::size_t>> families;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    pieces[p].centre *= pieces[p].area > 0 ? 1 / pieces[p].area : 0;
    families[{ pieces[p].kind, pieces[p].pair.first, pieces[p].pair.second }].push_back(p);
  }
  std::vector<MeshPatch> patches;
  rank.assign(pieces.size(), 0);
  for (const auto& family : families)
  {
    std::vector<Piece> members;
    for (std::size_t p : family.second)
    {
      members.push_back({ pieces[p].area, pieces[p].centre });
    }
    std::size_t number = 0;
    for (std::size_t m : OrderPieces(members, extent))
    {
      const std::size_t p = family.second[m];
      rank[p] = static_cast<int>(patches.size());
      patches.push_back(pieces[p]);
      patches.back().name = naming.Name(patches.back(), ++number, materials);
    }
  }
  return patches;
}

} // namespace

std::string MaterialName(const std::map<int, std::string>& names, int material)
{
  const auto found = names.find(material);
  return found == names.end() ? "material_" + std::to_string(material) : found->second;
}

Result<FindPatchesReport> FindPatches(const VolumeMesh& mesh, const TriangleComplex* surface,
                                      const FindPatchesOptions& options, MeshPatches& patches,
                                      Monitor& monitor, const CellFaces* known)
{
  if (!(options.surfaceScale > 0 && std::isfinite(options.surfaceScale)))
  {
    return InvalidOption("surfaceScale is " + std::to_string(options.surfaceScale) + ", but must be above 0");
  }
  monitor.Progress(0, "Finding the faces");
  const std::vector<RawFace> raw = CollectFaces(mesh, surface, options.surfaceScale, known, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  monitor.Progress(0.7, "Telling the patches apart");
  std::size_t count = 0;
  const std::vector<std::size_t> pieceOf = FindPieces(raw, count);
  std::vector<MeshPatch> pieces(count);
  for (std::size_t f = 0; f < raw.size(); ++f)
  {
    pieces[pieceOf[f]].kind = raw[f].group.kind;
    pieces[pieceOf[f]].pair = raw[f].group.pair;
    Measure(mesh, raw[f], pieces[pieceOf[f]]);
  }
  FindPatchesReport report;
  Naming naming(options.names, report);
  MeshPatches found;
  for (int material : std::set<int>(mesh.materials.begin(), mesh.materials.end()))
  {
    const std::string own = std::to_string(material);
    const std::string name = naming.Replace(own);
    if (name != own)
    {
      found.materialNames[material] = name;
    }
  }
  std::vector<int> rank;
  found.patches = NamePatches(std::move(pieces), ExtentOf(mesh.points), found.materialNames, naming, rank);
  naming.Close();
  for (std::size_t f = 0; f < raw.size(); ++f)
  {
    found.faces.push_back(raw[f].face);
    found.faces.back().patch = rank[pieceOf[f]];
  }
  std::stable_sort(found.faces.begin(), found.faces.end(),
                   [](const PatchFace& a, const PatchFace& b) { return a.patch < b.patch; });
  report.patches = static_cast<Id>(found.patches.size());
  report.faces = static_cast<Id>(found.faces.size());
  patches = std::move(found);
  monitor.Progress(1, "Patches named");
  return report;
}

} // namespace lamina
