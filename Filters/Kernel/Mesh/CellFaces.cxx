// SPDX-License-Identifier: BSD-3-Clause
#include "CellFaces.h"

#include <algorithm>

namespace lamina
{
namespace
{

constexpr Id Grain = 4096;

using Local = std::array<int, 4>;

// Counter-clockwise seen from outside, VTK's node orders: a wedge's first triangle has its normal outwards, a
// pyramid's base inwards.
constexpr Local TetLocal[] = { { { 1, 2, 3, -1 } },
                               { { 0, 3, 2, -1 } },
                               { { 0, 1, 3, -1 } },
                               { { 0, 2, 1, -1 } } };
constexpr Local WedgeLocal[] = { { { 0, 1, 2, -1 } },
                                 { { 3, 5, 4, -1 } },
                                 { { 0, 3, 4, 1 } },
                                 { { 1, 4, 5, 2 } },
                                 { { 2, 5, 3, 0 } } };
constexpr Local PyramidLocal[] = { { { 0, 3, 2, 1 } },
                                   { { 0, 1, 4, -1 } },
                                   { { 1, 2, 4, -1 } },
                                   { { 2, 3, 4, -1 } },
                                   { { 3, 0, 4, -1 } } };

struct LocalFaces
{
  const Local* faces;
  int count;
};

LocalFaces FacesOf(CellType type)
{
  switch (type)
  {
    case CellType::Wedge:
      return { WedgeLocal, 5 };
    case CellType::Pyramid:
      return { PyramidLocal, 5 };
    default:
      return { TetLocal, 4 };
  }
}

template<typename Visit>
void ForFaces(const VolumeMesh& mesh, Visit&& visit)
{
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    const int count = FaceCount(mesh.types[static_cast<std::size_t>(c)]);
    for (int local = 0; local < count; ++local)
    {
      visit(FaceOf(mesh, c, local));
    }
  }
}

/// Ascending, a triangle's -1 last.
std::array<Id, 4> Key(const CellFace& face)
{
  std::array<Id, 4> key = face.corners;
  const auto order = [&](std::size_t a, std::size_t b)
  {
    if (key[b] < key[a])
    {
      std::swap(key[a], key[b]);
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  if (face.IsQuad())
  {
    order(2, 3);
    order(1, 2);
    order(0, 1);
  }
  return key;
}

/// A face with its key, for sorting.
struct KeyedFace
{
  std::array<Id, 4> key;
  CellFace face;
};

bool ComesBefore(const KeyedFace& a, const KeyedFace& b)
{
  return a.key != b.key ? a.key < b.key : a.face.cell < b.face.cell;
}

void SortFaces(CellFace* begin, CellFace* end, std::vector<KeyedFace>& keyed)
{
  keyed.clear();
  for (const CellFace* face = begin; face != end; ++face)
  {
    keyed.push_back({ Key(*face), *face });
  }
  std::sort(keyed.begin(), keyed.end(), ComesBefore);
  for (const KeyedFace& entry : keyed)
  {
    *begin++ = entry.face;
  }
}

} // namespace

int FaceCount(CellType type)
{
  return FacesOf(type).count;
}

const std::array<int, 4>& FaceNodes(CellType type, int local)
{
  return FacesOf(type).faces[local];
}

CellFace FaceOf(const VolumeMesh& mesh, Id cell, int local)
{
  const Id* nodes = mesh.Cell(cell);
  const Local& corners = FaceNodes(mesh.types[static_cast<std::size_t>(cell)], local);
  CellFace face;
  face.cell = cell;
  for (std::size_t k = 0; k < 4; ++k)
  {
    face.corners[k] = corners[k] < 0 ? -1 : nodes[corners[k]];
  }
  return face;
}

int LocalFace(const VolumeMesh& mesh, const CellFace& face)
{
  const int count = FaceCount(mesh.types[static_cast<std::size_t>(face.cell)]);
  int local = 0;
  while (local < count - 1 && FaceOf(mesh, face.cell, local).corners != face.corners)
  {
    ++local;
  }
  return local;
}

CellFaces FindCellFaces(const VolumeMesh& mesh, Monitor& monitor)
{
  CellFaces all;
  std::vector<std::size_t> first(mesh.points.size() + 1, 0);
  const auto lowest = [](const CellFace& face)
  {
    return static_cast<std::size_t>(
      *std::min_element(face.corners.begin(), face.corners.begin() + (face.IsQuad() ? 4 : 3)));
  };
  ForFaces(mesh, [&](const CellFace& face) { ++first[lowest(face) + 1]; });
  for (std::size_t p = 1; p < first.size(); ++p)
  {
    first[p] += first[p - 1];
  }
  all.faces.resize(first.back());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  ForFaces(mesh, [&](const CellFace& face) { all.faces[next[lowest(face)]++] = face; });
  monitor.For(static_cast<Id>(mesh.points.size()), Grain,
              [&](Id begin, Id end)
              {
                std::vector<KeyedFace> keyed;
                for (std::size_t p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
                {
                  SortFaces(all.faces.data() + first[p], all.faces.data() + first[p + 1], keyed);
                }
              });
  all.startOfPoint.assign(mesh.points.size() + 1, 0);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    all.startOfPoint[p] = all.start.size();
    for (std::size_t i = first[p]; i < first[p + 1]; ++i)
    {
      if (i == first[p] || Key(all.faces[i]) != Key(all.faces[i - 1]))
      {
        all.start.push_back(i);
      }
    }
  }
  all.startOfPoint[mesh.points.size()] = all.start.size();
  all.start.push_back(all.faces.size());
  return all;
}

Id CellFaces::Find(const Triangle& corners) const
{
  CellFace face;
  std::copy(corners.begin(), corners.end(), face.corners.begin());
  const auto key = Key(face);
  const std::size_t p = static_cast<std::size_t>(key[0]);
  for (std::size_t g = this->startOfPoint[p]; g < this->startOfPoint[p + 1]; ++g)
  {
    if (Key(this->faces[this->start[g]]) == key)
    {
      return static_cast<Id>(g);
    }
  }
  return -1;
}

const std::vector<std::array<int, 2>>& EdgeNodes(CellType type)
{
  static const std::vector<std::array<int, 2>> tet{ { { 0, 1 } }, { { 1, 2 } }, { { 2, 0 } },
                                                    { { 0, 3 } }, { { 1, 3 } }, { { 2, 3 } } };
  static const std::vector<std::array<int, 2>> wedge{ { { 0, 1 } }, { { 1, 2 } }, { { 2, 0 } },
                                                      { { 3, 4 } }, { { 4, 5 } }, { { 5, 3 } },
                                                      { { 0, 3 } }, { { 1, 4 } }, { { 2, 5 } } };
  static const std::vector<std::array<int, 2>> pyramid{ { { 0, 1 } }, { { 1, 2 } }, { { 2, 3 } },
                                                        { { 3, 0 } }, { { 0, 4 } }, { { 1, 4 } },
                                                        { { 2, 4 } }, { { 3, 4 } } };
  return type == CellType::Tetrahedron ? tet : (type == CellType::Wedge ? wedge : pyramid);
}

bool AreOpposite(const CellFace& a, const CellFace& b)
{
  const std::size_t n = a.IsQuad() ? 4 : 3;
  const std::size_t shift =
    static_cast<std::size_t>(std::find(b.corners.begin(), b.corners.end(), a.corners[0]) - b.corners.begin());
  for (std::size_t k = 0; k < n; ++k)
  {
    if (a.corners[k] != b.corners[(shift + n - k) % n])
    {
      return false;
    }
  }
  return true;
}

} // namespace lamina
