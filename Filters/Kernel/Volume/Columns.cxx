// SPDX-License-Identifier: BSD-3-Clause
#include "Columns.h"

#include "../Geometry/Quality.h"
#include "../Geometry/VisibleDirection.h"
#include "../Search/Clearance.h"
#include "../Search/SelfIntersection.h"
#include "ColumnCells.h"

#include <algorithm>
#include <queue>

namespace lamina
{

namespace
{

constexpr double leastVisibility = 0.08; ///< below, a node counts as hidden: cells on it would be flat
constexpr double slopeOfHeight = 0.5;    ///< largest change of column height over length along the wall
constexpr double thinnestLayer = 0.05;   ///< of a tet's layer over its wall edge: thinner ones are bad tets
constexpr double thinnestColumn = 1e-4;  ///< of a column of prisms over its wall edge
constexpr double leastTetQuality = 0.12; ///< of tets in columns
constexpr int mostRounds = 120;

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

class Growth
{
public:
  Growth(const Wall& wall, const ColumnOptions& options, Monitor& monitor)
    : W(wall)
    , Options(options)
    , Watch(monitor)
  {
  }
  Result<Columns> Run();

private:
  void FindDirections();
  void SmoothDirections();
  double Sight(Id v, const Vec3& direction) const;
  void SetHeights();
  void LimitSlopes();
  double WallEdge(Id v) const { return this->Edge[U(v)]; }
  bool IsSound(Id triangle) const;
  Id MendCells(int round);
  Id MendFronts(int round);
  void Shrink(Id v, double factor);
  void Stop(Id v);
  std::vector<Vec3> FrontPoints() const;

  const Wall& W;
  const ColumnOptions& Options;
  Monitor& Watch;
  Columns C;
  std::vector<Vec3> Normals; ///< of triangles
  std::vector<double> Seen;  ///< least cosine between a node's direction and its faces
  std::vector<double> Edge;  ///< mean length of the wall's edges at a node
  std::vector<double>
    WallGap;               ///< clearance of the wall's triangles around a node, as far as layers could care
  std::vector<char> Dirty; ///< triangles to test (again)
};

double Growth::Sight(Id v, const Vec3& direction) const
{
  double least = 1;
  for (Id t : Row(this->W.star, v))
  {
    least = std::min(least, Dot(direction, this->Normals[U(t)]));
  }
  return least;
}

void Growth::FindDirections()
{
  const std::size_t count = this->W.points.size();
  for (const Triangle& t : this->W.triangles)
  {
    this->Normals.push_back(Normalized(AreaVector2(this->W.points, t)));
  }
  this->C.direction.resize(count);
  this->Seen.resize(count);
  this->Edge.assign(count, 0);
  this->C.hidden.assign(count, 0);
  this->Watch.For(static_cast<Id>(count), 512,
                  [&](Id begin, Id end)
                  {
                    for (Id v = begin; v < end; ++v)
                    {
                      std::vector<Vec3> normals;
                      double sum = 0;
                      double edges = 0;
                      for (Id t : Row(this->W.star, v))
                      {
                        normals.push_back(this->Normals[U(t)]);
                        for (Id p : this->W.triangles[U(t)])
                        {
                          sum += p == v ? 0 : Norm(this->W.points[U(p)] - this->W.points[U(v)]);
                          edges += p == v ? 0 : 1;
                        }
                      }
                      const VisibleDirection best = FindVisibleDirection(normals);
                      this->C.direction[U(v)] = best.direction;
                      this->Seen[U(v)] = best.leastCosine;
                      this->Edge[U(v)] = edges > 0 ? sum / edges : 0;
                      this->C.hidden[U(v)] = best.leastCosine < leastVisibility ? 1 : 0;
                    }
                  });
}

/// Neighbouring columns should not cross: take the mean direction of the ring where it still sees all faces
/// nearly as well as the best one does.
void Growth::SmoothDirections()
{
  const std::vector<double> best = this->Seen;
  for (int pass = 0; pass < 8; ++pass)
  {
    const std::vector<Vec3> before = this->C.direction;
    this->Watch.For(static_cast<Id>(before.size()), 512,
                    [&](Id begin, Id end)
                    {
                      for (Id v = begin; v < end; ++v)
                      {
                        if (this->C.hidden[U(v)])
                        {
                          continue;
                        }
                        Vec3 sum;
                        for (Id t : Row(this->W.star, v))
                        {
                          for (Id p : this->W.triangles[U(t)])
                          {
                            sum += p == v || this->C.hidden[U(p)] ? Vec3{} : before[U(p)];
                          }
                        }
                        const Vec3 mean = Normalized(Normalized(sum) + before[U(v)]);
                        const double sight = this->Sight(v, mean);
                        if (sight >= 0.85 * best[U(v)])
                        {
                          this->C.direction[U(v)] = mean;
                          this->Seen[U(v)] = sight;
                        }
                      }
                    });
  }
}

/// The share of the thickness, at most what the ray along the column itself finds.
void Growth::SetHeights()
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
                      thickness = std::min(thickness, hit.t);
                      this->C.wanted[U(v)] = std::isfinite(thickness) ? this->Options.share * thickness : 0;
                    }
                  });
  this->C.height = this->C.wanted;
  this->WallGap = PointClearances(this->W.points, this->W.triangles, this->C.wanted, this->Watch);
}

/// Heights become the largest field below themselves whose slope along the wall's edges is limited; stopped
/// columns count as height 0, so that layers thin out towards them.
void Growth::LimitSlopes()
{
  using Item = std::pair<double, Id>;
  std::priority_queue<Item, std::vector<Item>, std::greater<Item>> queue;
  std::vector<double>& h = this->C.height;
  for (std::size_t v = 0; v < h.size(); ++v)
  {
    queue.push({ h[v], static_cast<Id>(v) });
  }
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

bool Growth::IsSound(Id t) const
{
  const Triangle& c = this->W.triangles[U(t)];
  if (this->C.Stopped(c[0]) && this->C.Stopped(c[1]) && this->C.Stopped(c[2]))
  {
    return true;
  }
  // What the wall triangle and the directions on it allow at no height: no cell can be better.
  double allowed = TriangleQuality(this->W.points[U(c[0])], this->W.points[U(c[1])], this->W.points[U(c[2])]);
  for (Id v : c)
  {
    allowed *= this->C.Stopped(v) ? 1 : std::max(0.0, Dot(this->C.direction[U(v)], this->Normals[U(t)]));
  }
  std::array<ColumnCell, 3> cells;
  const bool tets = this->Options.cells == ColumnCells::Tets;
  for (int layer = 1; layer <= this->C.layers; ++layer)
  {
    const int count = CellsOfTriangle(this->W, this->C, t, layer, this->Options.cells, cells);
    for (int i = 0; i < count; ++i)
    {
      const ColumnCell& cell = cells[static_cast<std::size_t>(i)];
      const double q = QualityOf(this->W, this->C, cell);
      double gate = std::min(0.3, 0.5 * allowed);
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

void Growth::Stop(Id v)
{
  this->C.height[U(v)] = 0;
  for (Id t : Row(this->W.star, v))
  {
    this->Dirty[U(t)] = 1;
  }
}

void Growth::Shrink(Id v, double factor)
{
  double& h = this->C.height[U(v)];
  if (h == 0)
  {
    return;
  }
  h *= factor;
  const bool tets = this->Options.cells == ColumnCells::Tets;
  const double least = tets ? thinnestLayer * this->C.layers : thinnestColumn;
  if (h < least * this->WallEdge(v))
  {
    this->Stop(v);
    return;
  }
  for (Id t : Row(this->W.star, v))
  {
    this->Dirty[U(t)] = 1;
  }
}

/// Tests the dirty triangles and shrinks the columns of those that fail. Returns how many failed.
Id Growth::MendCells(int round)
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
    if (round > mostRounds / 2)
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
    nodes.insert(nodes.end(), c.begin(), c.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  for (Id v : nodes)
  {
    this->Shrink(v, 0.8);
  }
  return failed;
}

std::vector<Vec3> Growth::FrontPoints() const
{
  std::vector<Vec3> front(this->W.points.size());
  for (std::size_t v = 0; v < front.size(); ++v)
  {
    front[v] = this->C.Place(this->W, static_cast<Id>(v), this->C.layers);
  }
  return front;
}

/// Shrinks the columns under front triangles that intersect others, or come nearer to them than the last
/// layer is high. Returns how many columns shrank.
Id Growth::MendFronts(int round)
{
  const std::vector<Vec3> front = this->FrontPoints();
  std::vector<double> factor(front.size(), 1);
  std::vector<char> hit(front.size(), 0);
  for (const auto& pair : FindIntersections(front, this->W.triangles, this->Watch))
  {
    for (Id t : pair)
    {
      for (Id v : this->W.triangles[U(t)])
      {
        hit[U(v)] = 1;
        factor[U(v)] = 0.7;
      }
    }
  }
  if (round < mostRounds / 3) // distance is a wish, freedom from intersections a must
  {
    std::vector<double> gap(front.size());
    const double last = this->C.layers > 0 ? 1 - this->C.fraction[U(this->C.layers - 1)] : 0;
    for (std::size_t v = 0; v < front.size(); ++v)
    {
      // At most half of what the wall itself has: there it is the next triangles of the same front that are
      // near.
      gap[v] = std::min(0.6 * last * this->C.height[v], 0.5 * this->WallGap[v]);
    }
    const std::vector<double> clearance = PointClearances(front, this->W.triangles, gap, this->Watch);
    for (std::size_t v = 0; v < front.size(); ++v)
    {
      if (clearance[v] < 0.99 * gap[v])
      {
        factor[v] = std::min(factor[v], std::max(0.7, 0.5 + 0.5 * clearance[v] / gap[v]) * 0.98);
      }
    }
  }
  Id count = 0;
  for (std::size_t v = 0; v < front.size(); ++v)
  {
    if (factor[v] < 1 && this->C.height[v] > 0)
    {
      ++count;
      if (hit[v] && round > 2 * mostRounds / 3)
      {
        this->Stop(static_cast<Id>(v));
      }
      else
      {
        this->Shrink(static_cast<Id>(v), factor[v]);
      }
    }
  }
  return count;
}

Result<Columns> Growth::Run()
{
  this->C.layers = this->Options.layers;
  double sum = 0;
  double step = 1;
  this->C.fraction = { 0 };
  for (int k = 0; k < this->C.layers; ++k, step *= this->Options.growth)
  {
    sum += step;
    this->C.fraction.push_back(sum);
  }
  for (double& f : this->C.fraction)
  {
    f /= sum > 0 ? sum : 1;
  }
  this->FindDirections();
  this->SmoothDirections();
  this->SetHeights();
  this->Dirty.assign(this->W.triangles.size(), 1);
  for (int round = 0; round < mostRounds && !this->Watch.Cancelled(); ++round)
  {
    this->LimitSlopes();
    this->Watch.Progress(static_cast<double>(round) / mostRounds, "growing layers");
    if (this->MendCells(round) == 0 && this->MendFronts(round) == 0)
    {
      return this->C;
    }
  }
  if (this->Watch.Cancelled())
  {
    return Cancelled();
  }
  std::vector<Vec3> places;
  for (std::size_t t = 0; t < this->Dirty.size(); ++t)
  {
    if (this->Dirty[t])
    {
      places.push_back(this->W.points[U(this->W.triangles[t][0])]);
    }
  }
  return Unreachable("no valid layers of material " + std::to_string(this->W.material) + " could be found" +
                       DescribePlaces(places) + ": refine the surface there, or ask for fewer layers",
                     places);
}

} // namespace

Result<Columns> GrowColumns(const Wall& wall, const ColumnOptions& options, Monitor& monitor)
{
  return Growth(wall, options, monitor).Run();
}

} // namespace lamina
