// SPDX-License-Identifier: BSD-3-Clause
#include "ColumnGrowth.h"

#include "../Geometry/Quality.h"
#include "../Search/Clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

namespace lamina
{

namespace
{

constexpr double slopeOfHeight = 0.5;   ///< largest change of column height over length along the wall
constexpr double thinnestLayer = 0.075; ///< of a tet's layer over its wall edge: thinner ones are bad tets
constexpr double largestShare = 0.45;   ///< of the thickness, where a length is asked for
constexpr double tallestPrism = 0.3;    ///< of the last layer over its wall edge
constexpr double largestPrism = 1.05;   ///< of the last layer, over a regular tet on the front
constexpr double lowering = 0.96;       ///< of columns at a time, until their prisms are no larger
constexpr int MostLowerings = 60;
constexpr double thinnestColumn = 1e-4; ///< of a column of prisms over its wall edge

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

} // namespace

/// Prisms as high as the wall's edges are long: higher ones would be larger than any tet of the core on them.
double ColumnGrowth::TallestColumn(Id v) const
{
  if (this->Options.cells == ColumnCells::Tets || this->C.layers == 0)
  {
    return std::numeric_limits<double>::infinity();
  }
  const double last = 1 - this->C.fraction[U(this->C.layers - 1)];
  return tallestPrism * this->WallEdge(v) / last;
}

/// How far the column may run before it leaves through the plane of a cap near it.
double ColumnGrowth::RoomBeforeCaps(Id v) const
{
  double room = std::numeric_limits<double>::infinity();
  const Vec3& m = this->C.direction[U(v)];
  for (std::size_t c = 0; c < this->W.caps.size(); ++c)
  {
    const WallCap& cap = this->W.caps[c];
    const double towards = Dot(m, cap.normal);
    if (this->W.capOf[U(v)] == static_cast<int>(c) || !(towards > 0))
    {
      continue;
    }
    const double way = Dot(cap.origin - this->W.points[U(v)], cap.normal) / towards;
    const Vec3 place = this->W.points[U(v)] + way * m;
    room = way > 0 && Norm(place - cap.origin) <= cap.extent ? std::min(room, way) : room;
  }
  return room;
}

/// Whether the last prism is not much larger than a regular tet on the front's triangle: the core on it could
/// only be of much smaller cells.
bool ColumnGrowth::IsFollowedWell(Id t) const
{
  const Triangle& c = this->W.triangles[U(t)];
  if (this->C.Stopped(c[0]) || this->C.Stopped(c[1]) || this->C.Stopped(c[2]))
  {
    return true;
  }
  std::array<Vec3, 6> p;
  for (std::size_t i = 0; i < 3; ++i)
  {
    p[i] = this->C.Place(this->W, c[2 - i], this->C.layers - 1);
    p[i + 3] = this->C.Place(this->W, c[2 - i], this->C.layers);
  }
  const double area = 0.5 * Norm(Cross(p[4] - p[3], p[5] - p[3]));
  const double regular = std::sqrt(8 / std::sqrt(27.0)) / 3 * std::pow(area, 1.5);
  return WedgeVolume(p) < largestPrism * regular;
}

/// Lowers columns until no last prism is too large for the core; that is then what is asked for.
void ColumnGrowth::LowerLargePrisms()
{
  std::vector<Id> all(this->W.triangles.size());
  std::iota(all.begin(), all.end(), Id{ 0 });
  this->Dirty.assign(all.size(), 1);
  for (int pass = 0; pass < MostLowerings && !this->Watch.Cancelled(); ++pass)
  {
    std::vector<char> isLarge(all.size(), 0);
    this->Watch.For(static_cast<Id>(all.size()), 512,
                    [&](Id begin, Id end)
                    {
                      for (Id t = begin; t < end; ++t)
                      {
                        isLarge[U(t)] = this->Dirty[U(t)] != 0 && !this->IsFollowedWell(t) ? 1 : 0;
                      }
                    });
    std::fill(this->Dirty.begin(), this->Dirty.end(), 0);
    std::vector<Id> nodes;
    for (Id t : all)
    {
      const Triangle& c = this->W.triangles[U(t)];
      nodes.insert(nodes.end(), c.begin(), isLarge[U(t)] ? c.end() : c.begin());
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    if (nodes.empty())
    {
      break;
    }
    for (Id v : nodes)
    {
      this->Shrink(v, lowering);
    }
  }
  this->C.wanted = this->C.height;
}

/// The height asked for and the one to start from.
void ColumnGrowth::SetHeight(Id v, double thickness)
{
  double fixed = this->Options.total;
  if (this->Options.firstHeight > 0 && this->C.layers > 0)
  {
    fixed = this->Options.firstHeight / this->C.fraction[1];
  }
  const double byShare = std::min(this->Options.share * thickness, this->TallestColumn(v));
  this->C.wanted[U(v)] = fixed > 0 ? fixed : byShare;
  const double height = fixed > 0 ? std::min(fixed, largestShare * thickness) : byShare;
  this->C.height[U(v)] = height < this->LeastColumn(v) ? 0 : height;
}

/// Lower columns stop.
double ColumnGrowth::LeastColumn(Id v) const
{
  const bool tets = this->Options.cells == ColumnCells::Tets;
  return (tets ? thinnestLayer * this->C.layers : thinnestColumn) * this->WallEdge(v);
}

/// The share of the thickness, at most what the ray along the column itself finds.
void ColumnGrowth::SetHeights()
{
  const TriangleTree tree(this->W.points, this->W.triangles);
  const std::size_t count = this->W.points.size();
  this->C.height.assign(count, 0);
  this->C.wanted.assign(count, 0);
  this->Watch.For(static_cast<Id>(count), 256,
                  [&](Id begin, Id end)
                  {
                    for (Id v = begin; v < end; ++v)
                    {
                      if (this->C.hidden[U(v)] || this->W.fixed[U(v)])
                      {
                        continue;
                      }
                      const Vec3& m = this->C.direction[U(v)];
                      double thickness = std::numeric_limits<double>::infinity();
                      if (!this->W.thickness.empty() && this->W.thickness[U(v)] > 0)
                      {
                        thickness = this->W.thickness[U(v)];
                      }
                      const auto hit = tree.FirstHit(
                        this->W.points[U(v)], m, 1e-6 * this->WallEdge(v), thickness,
                        [&](Id t)
                        {
                          const Triangle& c = this->W.triangles[U(t)];
                          return c[0] != v && c[1] != v && c[2] != v && Dot(this->Normals[U(t)], m) < 0;
                        });
                      thickness = std::min({ thickness, hit.t, this->RoomBeforeCaps(v) });
                      this->SetHeight(v, std::isfinite(thickness) ? thickness : 0);
                    }
                  });
  const bool isFixed = this->Options.total > 0 || this->Options.firstHeight > 0;
  if (this->Options.cells == ColumnCells::Prisms && !isFixed)
  {
    this->LowerLargePrisms();
  }
  std::vector<double> reach(count);
  for (std::size_t v = 0; v < count; ++v)
  {
    reach[v] = std::max(this->C.wanted[v], 2 * GapOfEdge * this->Edge[v]);
  }
  this->WallGap = PointClearances(this->W.points, this->W.triangles, reach, this->Watch);
}

/// Heights become the largest field below themselves whose slope along the wall's edges is limited; stopped
/// columns count as height 0, so that layers thin out towards them. Only columns that became lower can make
/// others too high.
void ColumnGrowth::LimitSlopes()
{
  using Item = std::pair<double, Id>;
  std::priority_queue<Item, std::vector<Item>, std::greater<Item>> queue;
  std::vector<double>& h = this->C.height;
  for (Id v : this->Lowered)
  {
    queue.push({ h[U(v)], v });
  }
  this->Lowered.clear();
  while (!queue.empty())
  {
    const Item item = queue.top();
    queue.pop();
    if (item.first > h[U(item.second)])
    {
      continue;
    }
    for (Id t : Row(this->W.star, item.second))
    {
      for (Id p : this->W.triangles[U(t)])
      {
        const double limit =
          item.first + slopeOfHeight * Norm(this->W.points[U(p)] - this->W.points[U(item.second)]);
        if (limit < h[U(p)])
        {
          h[U(p)] = limit;
          queue.push({ limit, p });
          for (Id changed : Row(this->W.star, p))
          {
            this->Dirty[U(changed)] = 1;
          }
        }
      }
    }
  }
}

void ColumnGrowth::Stop(Id v)
{
  this->C.height[U(v)] = 0;
  this->Lowered.push_back(v);
  for (Id t : Row(this->W.star, v))
  {
    this->Dirty[U(t)] = 1;
  }
}

void ColumnGrowth::Shrink(Id v, double factor)
{
  double& h = this->C.height[U(v)];
  if (h == 0)
  {
    return;
  }
  h *= factor;
  if (h < this->LeastColumn(v))
  {
    this->Stop(v);
    return;
  }
  this->Lowered.push_back(v);
  for (Id t : Row(this->W.star, v))
  {
    this->Dirty[U(t)] = 1;
  }
}

} // namespace lamina
