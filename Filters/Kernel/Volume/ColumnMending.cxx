// SPDX-License-Identifier: BSD-3-Clause
#include "ColumnCells.h"
#include "ColumnGrowth.h"

#include "../Geometry/Quality.h"

#include <algorithm>

namespace lamina
{

namespace
{

/// Of tets in columns: improvement lifts what is poor, but shrinking a column that is thin already does not.
constexpr double leastTetQuality = 0.03;
constexpr double shareOfDeepest = 0.9; ///< from which a column counts as deep as the deepest

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

} // namespace

/// What the wall triangle and the directions on it allow at no height: no cell can be better.
double ColumnGrowth::AllowedOn(Id t) const
{
  const Triangle& c = this->W.triangles[U(t)];
  double least = 1;
  double product = TriangleQuality(this->W.points[U(c[0])], this->W.points[U(c[1])], this->W.points[U(c[2])]);
  for (Id v : c)
  {
    const double cosine = this->C.Stopped(v) ? 1 : Dot(this->C.direction[U(v)], this->Normals[U(t)]);
    least = std::min(least, this->GroundAt(t, v) * cosine);
    product *= std::max(0.0, cosine);
  }
  return this->Options.cells == ColumnCells::Tets ? product : std::max(0.0, least);
}

bool ColumnGrowth::IsSound(Id t) const
{
  const Triangle& c = this->W.triangles[U(t)];
  if (this->C.Stopped(c[0]) && this->C.Stopped(c[1]) && this->C.Stopped(c[2]))
  {
    return true;
  }
  const double allowed = this->AllowedOn(t);
  std::array<ColumnCell, 3> cells;
  const bool tets = this->Options.cells == ColumnCells::Tets;
  for (int layer = 1; layer <= this->C.layers; ++layer)
  {
    const int count = CellsOfTriangle(this->W, this->C, t, layer, this->Options.cells, cells);
    for (int i = 0; i < count; ++i)
    {
      const ColumnCell& cell = cells[static_cast<std::size_t>(i)];
      const double q = QualityOf(this->W, this->C, cell);
      // Half of it, and what is asked for if lower prisms can have it.
      const double asked = std::min(1.05 * this->Options.leastQuality, 0.98 * allowed);
      double gate = std::max(std::min(0.3, 0.5 * allowed), asked);
      if (tets)
      {
        gate = std::min(leastTetQuality, allowed);
      }
      else if (cell.type != CellType::Wedge)
      {
        gate = 0;
      }
      if (!(q > gate))
      {
        return false;
      }
    }
  }
  if (tets)
  {
    // Tets flatten with the layer, and the front must keep enough of the triangle to carry a core.
    std::array<Vec3, 3> top;
    for (std::size_t i = 0; i < 3; ++i)
    {
      top[i] = this->C.Place(this->W, c[i], this->C.layers);
    }
    return TriangleQuality(top[0], top[1], top[2]) > std::min(0.2, 0.5 * allowed);
  }
  return true;
}

/// Adds the columns of an unsound triangle that are to shrink. Of tets' these are the ones that reach deepest
/// below it: at a ridge the others, which stand aslant, would run ahead of them to nothing and help nobody.
void ColumnGrowth::AddTall(Id t, std::vector<Id>& nodes) const
{
  const Triangle& c = this->W.triangles[U(t)];
  const auto depth = [&](Id v)
  { return this->C.height[U(v)] * Dot(this->C.direction[U(v)], this->Normals[U(t)]); };
  const double deepest = std::max({ depth(c[0]), depth(c[1]), depth(c[2]) });
  for (Id v : c)
  {
    if (this->Options.cells == ColumnCells::Prisms || depth(v) >= shareOfDeepest * deepest)
    {
      nodes.push_back(v);
    }
  }
}

/// Tests the dirty triangles and shrinks the columns of those that fail. Returns how many failed.
Id ColumnGrowth::MendCells(int round)
{
  std::vector<Id> work;
  for (std::size_t t = 0; t < this->Dirty.size(); ++t)
  {
    if (this->Dirty[t])
    {
      work.push_back(static_cast<Id>(t));
    }
  }
  std::vector<char> bad(work.size(), 0);
  this->Watch.For(static_cast<Id>(work.size()), 256,
                  [&](Id begin, Id end)
                  {
                    for (Id i = begin; i < end; ++i)
                    {
                      bad[U(i)] = this->IsSound(work[U(i)]) ? 0 : 1;
                    }
                  });
  std::fill(this->Dirty.begin(), this->Dirty.end(), 0);
  std::vector<Id> nodes;
  Id failed = 0;
  for (std::size_t i = 0; i < work.size(); ++i)
  {
    if (!bad[i])
    {
      continue;
    }
    ++failed;
    const Triangle& c = this->W.triangles[U(work[i])];
    this->Dirty[U(work[i])] = 1;
    // A triangle that has failed often: its most slanted column stops.
    if (round > MostRounds / 2)
    {
      Id worst = -1;
      for (Id v : c)
      {
        if (!this->C.Stopped(v) && (worst < 0 || this->Seen[U(v)] < this->Seen[U(worst)]))
        {
          worst = v;
        }
      }
      if (worst >= 0)
      {
        this->Stop(worst);
      }
      continue;
    }
    this->AddTall(work[i], nodes);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  for (Id v : nodes)
  {
    this->Shrink(v, 0.8);
  }
  return failed;
}

std::vector<Vec3> ColumnGrowth::FrontPoints() const
{
  std::vector<Vec3> front(this->W.points.size());
  for (std::size_t v = 0; v < front.size(); ++v)
  {
    front[v] = this->C.Place(this->W, static_cast<Id>(v), this->C.layers);
  }
  return front;
}

/// How far the front at a point should be from other parts of itself.
double ColumnGrowth::GapWish(Id v, double edge) const
{
  // Layers of tets are thin against their edges, and so may be what is left between them.
  const double byEdge = this->Options.cells == ColumnCells::Tets ? 0 : GapOfEdge * edge;
  const double last = this->C.layers > 0 ? 1 - this->C.fraction[U(this->C.layers - 1)] : 0;
  // At most half of what the wall itself has: there it is the next triangles of the same front that are near.
  return std::min(std::max(0.6 * last * this->C.height[U(v)], byEdge), 0.5 * this->WallGap[U(v)]);
}

/// Shrinks the columns under front triangles that intersect others, or come nearer to them than the last
/// layer is high. Returns how many columns shrank.
Id ColumnGrowth::MendFronts(FrontCheck& front, int round)
{
  front.Move(this->FrontPoints(), this->Watch);
  const std::vector<Id> hits = front.Intersecting(this->Watch);
  std::vector<std::pair<Id, double>> wishes;
  for (Id v : hits)
  {
    wishes.push_back({ v, 0.7 });
  }
  if (round < MostRounds / 3) // distance is a wish, freedom from intersections a must
  {
    for (Id v : front.Touched())
    {
      front.SetGap(v, this->GapWish(v, front.EdgeAt(v)));
    }
    for (const auto& [v, clearance] : front.TooNear(this->Watch))
    {
      const double share = clearance / front.GapAt(v);
      if (share < 0.99)
      {
        wishes.push_back({ v, std::max(0.7, 0.5 + 0.5 * share) * 0.98 });
      }
    }
  }
  std::sort(wishes.begin(), wishes.end()); // the smaller factor of a point first
  Id count = 0;
  Id done = -1;
  for (const auto& [v, factor] : wishes)
  {
    if (v == done || this->C.Stopped(v))
    {
      continue;
    }
    done = v;
    ++count;
    if (round > 2 * MostRounds / 3 && std::binary_search(hits.begin(), hits.end(), v))
    {
      this->Stop(v);
    }
    else
    {
      this->Shrink(v, factor);
    }
  }
  return count;
}

} // namespace lamina
