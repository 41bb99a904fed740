// SPDX-License-Identifier: BSD-3-Clause
#include "ColumnGrowth.h"

#include "../Geometry/VisibleDirection.h"

#include <algorithm>

namespace lamina
{

namespace
{

constexpr double leastVisibility = 0.08; ///< below, a node counts as hidden: cells on it would be flat

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

} // namespace

double ColumnGrowth::Sight(Id v, const Vec3& direction) const
{
  double least = 1;
  for (Id t : Row(this->W.star, v))
  {
    least = std::min(least, Dot(direction, this->Normals[U(t)]));
  }
  return least;
}

void ColumnGrowth::FindDirections()
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
void ColumnGrowth::SmoothDirections()
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

} // namespace lamina
