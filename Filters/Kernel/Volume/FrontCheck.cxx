// SPDX-License-Identifier: BSD-3-Clause
#include "FrontCheck.h"

#include "../Geometry/Predicates.h"
#include "../Search/Clearance.h"

#include <algorithm>
#include <numeric>

namespace lamina
{

namespace
{

constexpr Id Grain = 256;

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

void SortUnique(std::vector<Id>& ids)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

/// Runs visit(item, list) for every item in threads; the lists' entries in the order of the items.
template<typename Visit>
std::vector<Id> Gather(const std::vector<Id>& items, Monitor& monitor, Visit&& visit)
{
  const Id count = static_cast<Id>(items.size());
  std::vector<std::vector<Id>> parts(U((count + Grain - 1) / Grain));
  monitor.For(static_cast<Id>(parts.size()), 1,
              [&](Id begin, Id end)
              {
                for (Id part = begin; part < end; ++part)
                {
                  for (Id i = part * Grain; i < std::min(count, (part + 1) * Grain); ++i)
                  {
                    visit(items[U(i)], parts[U(part)]);
                  }
                }
              });
  std::vector<Id> all;
  for (const std::vector<Id>& part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

Box BoxOf(const std::vector<Vec3>& points, const Triangle& t)
{
  Box box;
  for (Id p : t)
  {
    box.Add(points[U(p)]);
  }
  return box;
}

/// Squared distance of two boxes.
double Distance2(const Box& a, const Box& b)
{
  double sum = 0;
  for (int c = 0; c < 3; ++c)
  {
    const double gap = std::max({ 0.0, a.low[c] - b.high[c], b.low[c] - a.high[c] });
    sum += gap * gap;
  }
  return sum;
}

bool Same(const Vec3& a, const Vec3& b)
{
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

} // namespace

void FrontCheck::MarkChanged(const std::vector<Vec3>& points)
{
  if (this->IsNew)
  {
    this->Changed.resize(this->W.triangles.size());
    this->Points.resize(points.size());
    std::iota(this->Changed.begin(), this->Changed.end(), Id{ 0 });
    std::iota(this->Points.begin(), this->Points.end(), Id{ 0 });
    return;
  }
  this->Changed.clear();
  this->Points.clear();
  for (Id v = 0; v < static_cast<Id>(points.size()); ++v)
  {
    if (!Same(points[U(v)], this->Front[U(v)]))
    {
      const auto star = Row(this->W.star, v);
      this->Changed.insert(this->Changed.end(), star.begin(), star.end());
    }
  }
  SortUnique(this->Changed);
  for (Id t : this->Changed)
  {
    this->Points.insert(this->Points.end(), this->W.triangles[U(t)].begin(), this->W.triangles[U(t)].end());
  }
  SortUnique(this->Points);
}

void FrontCheck::Move(const std::vector<Vec3>& points, Monitor& monitor)
{
  this->MarkChanged(points);
  this->IsNew = false;
  this->Front = points;
  this->Tree.Refit();
  monitor.For(static_cast<Id>(this->Points.size()), Grain,
              [&](Id begin, Id end)
              {
                for (Id i = begin; i < end; ++i)
                {
                  const Id v = this->Points[U(i)];
                  double sum = 0;
                  int count = 0;
                  for (Id t : Row(this->W.star, v))
                  {
                    const Triangle& c = this->W.triangles[U(t)];
                    for (std::size_t k = 0; k < 3; ++k)
                    {
                      const Id a = c[k];
                      const Id b = c[(k + 1) % 3];
                      sum += a == v || b == v ? Norm(this->Front[U(b)] - this->Front[U(a)]) : 0;
                      count += a == v || b == v ? 1 : 0;
                    }
                  }
                  this->Edge[U(v)] = count > 0 ? sum / count : 0;
                }
              });
}

std::vector<Id> FrontCheck::Intersecting(Monitor& monitor) const
{
  std::vector<Id> found = Gather(
    this->Changed, monitor,
    [&](Id t, std::vector<Id>& list)
    {
      const auto& all = this->W.triangles;
      this->Tree.ForOverlaps(BoxOf(this->Front, all[U(t)]),
                             [&](Id other)
                             {
                               if (other != t && TrianglesIntersect(this->Front, all[U(std::min(t, other))],
                                                                    all[U(std::max(t, other))]))
                               {
                                 list.insert(list.end(), all[U(t)].begin(), all[U(t)].end());
                                 list.insert(list.end(), all[U(other)].begin(), all[U(other)].end());
                               }
                               return true;
                             });
    });
  SortUnique(found);
  return found;
}

double FrontCheck::CutoffOf(Id triangle) const
{
  const Triangle& t = this->W.triangles[U(triangle)];
  return std::max({ this->Gap[U(t[0])], this->Gap[U(t[1])], this->Gap[U(t[2])] });
}

std::vector<Id> FrontCheck::Suspects(Monitor& monitor) const
{
  if (this->Changed.size() == this->W.triangles.size())
  {
    return this->Changed;
  }
  const double reach = *std::max_element(this->Gap.begin(), this->Gap.end());
  std::vector<Id> found = Gather(this->Changed, monitor,
                                 [&](Id t, std::vector<Id>& list)
                                 {
                                   const Box own = BoxOf(this->Front, this->W.triangles[U(t)]);
                                   Box wide = own;
                                   wide.Grow(reach);
                                   this->Tree.ForOverlaps(wide,
                                                          [&](Id other)
                                                          {
                                                            const Box theirs =
                                                              BoxOf(this->Front, this->W.triangles[U(other)]);
                                                            const double cutoff = this->CutoffOf(other);
                                                            if (Distance2(own, theirs) < cutoff * cutoff)
                                                            {
                                                              list.push_back(other);
                                                            }
                                                            return true;
                                                          });
                                 });
  for (Id v : this->Points)
  {
    const auto star = Row(this->W.star, v);
    found.insert(found.end(), star.begin(), star.end());
  }
  SortUnique(found);
  return found;
}

std::vector<std::pair<Id, double>> FrontCheck::TooNear(Monitor& monitor) const
{
  if (this->Changed.empty())
  {
    return {};
  }
  const std::vector<Id> suspects = this->Suspects(monitor);
  std::vector<double> distance(suspects.size());
  monitor.For(static_cast<Id>(suspects.size()), Grain,
              [&](Id begin, Id end)
              {
                for (Id i = begin; i < end; ++i)
                {
                  const Id t = suspects[U(i)];
                  distance[U(i)] =
                    TriangleClearance(this->Tree, this->Front, this->W.triangles, t, this->CutoffOf(t));
                }
              });
  std::vector<std::pair<Id, double>> near;
  for (std::size_t i = 0; i < suspects.size(); ++i)
  {
    for (Id v : this->W.triangles[U(suspects[i])])
    {
      if (distance[i] < this->Gap[U(v)])
      {
        near.push_back({ v, distance[i] });
      }
    }
  }
  // The nearest first of each point.
  std::sort(near.begin(), near.end());
  near.erase(
    std::unique(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first == b.first; }),
    near.end());
  return near;
}

} // namespace lamina
