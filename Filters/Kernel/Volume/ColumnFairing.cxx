// SPDX-License-Identifier: BSD-3-Clause
#include "ColumnCells.h"
#include "ColumnGrowth.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

namespace
{

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

constexpr int MostPasses = 6;
constexpr double FirstStep = 0.3; ///< of the smaller of a column's height and its wall edge
constexpr int Halvings = 4;
constexpr double LeastGain = 1e-3; ///< of quality: less is no improvement

} // namespace

std::array<Vec3, 2> FrameOf(const Vec3& n)
{
  const Vec3 axis = std::abs(n.x) < 0.6 ? Vec3{ 1, 0, 0 } : Vec3{ 0, 1, 0 };
  const Vec3 u = Normalized(Cross(n, axis));
  return { { u, Cross(n, u) } };
}

double ColumnGrowth::WorstOf(Id triangle, double enough) const
{
  double worst = enough;
  std::array<ColumnCell, 3> cells;
  for (int layer = 1; layer <= this->C.layers && worst > 0; ++layer)
  {
    const int count = CellsOfTriangle(this->W, this->C, triangle, layer, this->Options.cells, cells);
    for (int i = 0; i < count; ++i)
    {
      // What stands beside a stopped column is thin whatever is done: prisms must not pay for it.
      const double quality = QualityOf(this->W, this->C, cells[U(i)]);
      const bool isPrism = cells[U(i)].type == CellType::Wedge;
      worst = std::min(worst, isPrism || !(quality > 0) ? quality : 1);
    }
  }
  return worst;
}

double ColumnGrowth::WorstAround(Id v, double atLeast, double enough) const
{
  double worst = enough;
  for (Id t : Row(this->W.star, v))
  {
    worst = std::min(worst, this->WorstOf(t, worst));
    if (worst <= atLeast)
    {
      break;
    }
  }
  return worst;
}

void ColumnGrowth::PlaceTop(Id v, const Vec3& offset)
{
  const double height = Norm(offset);
  this->C.height[U(v)] = height;
  this->C.direction[U(v)] = offset * (1 / height);
}

bool ColumnGrowth::ImproveColumn(Id v, double target)
{
  const double first = this->WorstAround(v, -1e30, target);
  double best = first;
  Vec3 offset = this->C.height[U(v)] * this->C.direction[U(v)];
  const double highest = this->C.height[U(v)];
  double step = FirstStep * std::min(highest, this->WallEdge(v));
  for (int halving = 0; halving < Halvings && best < target; step *= 0.5, ++halving)
  {
    for (bool again = true; again && best < target;)
    {
      again = false;
      const Vec3 up = Normalized(offset);
      const std::array<Vec3, 2> frame = FrameOf(up);
      for (const Vec3& way : { frame[0], -1.0 * frame[0], frame[1], -1.0 * frame[1], -1.0 * up })
      {
        const Vec3 moved = this->Allowed(v, offset + step * way);
        if (Norm(moved) > highest || Norm(moved) == 0 || this->Sight(v, Normalized(moved)) <= 0)
        {
          continue;
        }
        this->PlaceTop(v, moved);
        const double worst = this->WorstAround(v, best, target);
        if (worst > best + LeastGain)
        {
          best = worst;
          offset = moved;
          again = true;
        }
      }
    }
  }
  this->PlaceTop(v, offset);
  return best > first;
}

std::vector<Id> ColumnGrowth::PoorColumns(double target)
{
  const Id count = static_cast<Id>(this->W.triangles.size());
  std::vector<char> poor(U(count), 0);
  this->Watch.For(count, 256,
                  [&](Id begin, Id end)
                  {
                    for (Id t = begin; t < end; ++t)
                    {
                      poor[U(t)] = this->WorstOf(t, target) < target ? 1 : 0;
                    }
                  });
  std::vector<Id> nodes;
  for (Id t = 0; t < count; ++t)
  {
    for (Id v : this->W.triangles[U(t)])
    {
      if (poor[U(t)] && !this->C.Stopped(v) && this->Frozen[U(v)] == 0)
      {
        nodes.push_back(v);
      }
    }
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

std::vector<Id> ColumnGrowth::TakeApart(std::vector<Id>& nodes) const
{
  std::vector<char> near(this->W.points.size(), 0);
  std::vector<Id> taken;
  std::vector<Id> left;
  for (Id v : nodes)
  {
    if (near[U(v)])
    {
      left.push_back(v);
      continue;
    }
    taken.push_back(v);
    for (Id t : Row(this->W.star, v))
    {
      for (Id p : this->W.triangles[U(t)])
      {
        near[U(p)] = 1;
      }
    }
  }
  nodes = std::move(left);
  return taken;
}

Id ColumnGrowth::FairColumns(double target)
{
  Id improved = 0;
  for (int pass = 0; pass < MostPasses && !this->Watch.Cancelled(); ++pass)
  {
    std::vector<Id> nodes = this->PoorColumns(target);
    Id moved = 0;
    while (!nodes.empty() && !this->Watch.Cancelled())
    {
      const std::vector<Id> apart = this->TakeApart(nodes);
      std::vector<char> changed(apart.size(), 0);
      this->Watch.For(static_cast<Id>(apart.size()), 8,
                      [&](Id begin, Id end)
                      {
                        for (Id i = begin; i < end; ++i)
                        {
                          changed[U(i)] = this->ImproveColumn(apart[U(i)], target) ? 1 : 0;
                        }
                      });
      moved += std::count(changed.begin(), changed.end(), 1);
    }
    improved += moved;
    if (moved == 0)
    {
      break;
    }
  }
  return improved;
}

} // namespace lamina
