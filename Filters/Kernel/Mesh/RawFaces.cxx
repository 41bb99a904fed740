// SPDX-License-Identifier: BSD-3-Clause
#include "RawFaces.h"

#include "Adjacency.h"
#include "Openings.h"
#include "PointTable.h"

#include <algorithm>
#include <numeric>

namespace lamina
{
namespace
{

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

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

} // namespace

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

} // namespace lamina
