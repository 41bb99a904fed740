// SPDX-License-Identifier: BSD-3-Clause
#include "TetFaces.h"

#include <algorithm>
#include <tuple>

namespace lamina
{
namespace
{

constexpr Id Grain = 8192;

Triangle Sorted(Triangle t)
{
  std::sort(t.begin(), t.end());
  return t;
}

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

void SumUp(std::vector<std::size_t>& start)
{
  for (std::size_t p = 1; p < start.size(); ++p)
  {
    start[p] += start[p - 1];
  }
}

} // namespace

FaceTable::FaceTable(const std::vector<Triangle>& faces, Id pointCount)
  : Start(Index(pointCount) + 1, 0)
  , Entries(faces.size())
{
  for (const Triangle& face : faces)
  {
    ++this->Start[Index(Sorted(face)[0]) + 1];
  }
  SumUp(this->Start);
  std::vector<std::size_t> next(this->Start.begin(), this->Start.end() - 1);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const Triangle s = Sorted(faces[f]);
    this->Entries[next[Index(s[0])]++] = { s[1], s[2], static_cast<Id>(f) };
  }
}

Id FaceTable::Find(const Triangle& corners) const
{
  const Triangle s = Sorted(corners);
  if (Index(s[0]) + 1 >= this->Start.size())
  {
    return -1;
  }
  for (std::size_t i = this->Start[Index(s[0])]; i < this->Start[Index(s[0]) + 1]; ++i)
  {
    if (this->Entries[i].middle == s[1] && this->Entries[i].high == s[2])
    {
      return this->Entries[i].face;
    }
  }
  return -1;
}

std::vector<std::array<Id, 4>> FindTetNeighbours(const std::vector<std::array<Id, 4>>& tets, Id pointCount,
                                                 Monitor& monitor)
{
  struct Side
  {
    Id middle;
    Id high;
    Id face; ///< 4 * tet + opposite node
  };
  std::vector<std::size_t> start(Index(pointCount) + 1, 0);
  for (const auto& tet : tets)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      ++start[Index(Sorted(TetFace(tet, k))[0]) + 1];
    }
  }
  SumUp(start);
  std::vector<Side> sides(4 * tets.size());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for (std::size_t t = 0; t < tets.size(); ++t)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Triangle s = Sorted(TetFace(tets[t], k));
      sides[next[Index(s[0])]++] = { s[1], s[2], static_cast<Id>(4 * t + k) };
    }
  }
  std::vector<std::array<Id, 4>> neighbours(tets.size(), std::array<Id, 4>{ { -1, -1, -1, -1 } });
  const auto slot = [&](Id face) -> Id& { return neighbours[Index(face / 4)][Index(face % 4)]; };
  monitor.For(
    pointCount, Grain,
    [&](Id begin, Id end)
    {
      for (Id p = begin; p < end; ++p)
      {
        const auto first = sides.begin() + static_cast<std::ptrdiff_t>(start[Index(p)]);
        const auto last = sides.begin() + static_cast<std::ptrdiff_t>(start[Index(p) + 1]);
        std::sort(first, last,
                  [](const Side& a, const Side& b)
                  { return std::tie(a.middle, a.high, a.face) < std::tie(b.middle, b.high, b.face); });
        for (auto from = first; from != last;)
        {
          const auto to = std::find_if(
            from, last, [&](const Side& s) { return s.middle != from->middle || s.high != from->high; });
          if (to - from == 2)
          {
            slot(from->face) = (from + 1)->face / 4;
            slot((from + 1)->face) = from->face / 4;
          }
          const bool isCrowded = to - from > 2;
          for (; from != to; ++from)
          {
            slot(from->face) = isCrowded ? -2 : slot(from->face);
          }
        }
      }
    });
  return neighbours;
}

} // namespace lamina
