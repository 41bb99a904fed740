// SPDX-License-Identifier: BSD-3-Clause
#include "ColumnGrowth.h"

#include "../Geometry/Quality.h"
#include "../Geometry/VisibleDirection.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

namespace
{

constexpr double leastVisibility = 0.08; ///< below, a node counts as hidden: cells on it would be flat
constexpr double goodVisibility = 0.4;   ///< from here on prisms of the quality asked for are a must,
constexpr double goodTriangle = 0.3;     ///< if the faces are good, too
constexpr double enoughGround = 0.4;     ///< for prisms: directions that give it need no search
constexpr double enoughSight = 0.3;      ///< what no smoothing of directions may take away

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

} // namespace

/// What the triangle allows at its corner to a prism however low, along a direction of cosine 1 with its
/// normal: its shape, and the sine of the corner, normalised, for the two measures of a prism (Quality.h).
/// Tets of columns are improved later: for them all triangles count alike.
double ColumnGrowth::GroundAt(Id triangle, Id v) const
{
  if (this->Options.cells == ColumnCells::Tets)
  {
    return 1;
  }
  const Triangle& t = this->W.triangles[U(triangle)];
  std::size_t k = 0;
  while (t[k] != v)
  {
    ++k;
  }
  const Vec3& p = this->W.points[U(v)];
  const Vec3& q = this->W.points[U(t[(k + 1) % 3])];
  const Vec3& r = this->W.points[U(t[(k + 2) % 3])];
  const double sides = Norm(q - p) * Norm(r - p);
  const double sine = sides > 0 ? Norm(Cross(q - p, r - p)) / sides : 0;
  return std::min(TriangleQuality(p, q, r), 2 / std::sqrt(3.0) * sine);
}

Vec3 ColumnGrowth::Allowed(Id v, const Vec3& vector) const
{
  const int cap = this->W.capOf[U(v)];
  if (cap < 0)
  {
    return vector;
  }
  const Vec3& normal = this->W.caps[U(cap)].normal;
  return vector - Dot(vector, normal) * normal;
}

double ColumnGrowth::Sight(Id v, const Vec3& direction) const
{
  double least = 1;
  for (Id t : Row(this->W.star, v))
  {
    least = std::min(least, Dot(direction, this->Normals[U(t)]) * this->GroundAt(t, v));
  }
  return least;
}

/// The direction that sees all faces best; where that would not do for prisms the one along which the worst
/// of them will be best.
void ColumnGrowth::FindDirection(Id v)
{
  std::vector<Vec3> normals;
  std::vector<Vec3> weighted;
  double sum = 0;
  double edges = 0;
  double leastTriangle = 1;
  for (Id t : Row(this->W.star, v))
  {
    const Triangle& c = this->W.triangles[U(t)];
    leastTriangle = std::min(leastTriangle, TriangleQuality(this->W.points[U(c[0])], this->W.points[U(c[1])],
                                                            this->W.points[U(c[2])]));
    normals.push_back(this->Allowed(v, this->Normals[U(t)]));
    weighted.push_back(this->GroundAt(t, v) * normals.back());
    for (Id p : this->W.triangles[U(t)])
    {
      sum += p == v ? 0 : Norm(this->W.points[U(p)] - this->W.points[U(v)]);
      edges += p == v ? 0 : 1;
    }
  }
  // In a plane normals count by what of them lies in it.
  const bool isOnRim = this->W.capOf[U(v)] >= 0;
  const VisibleDirection seen = isOnRim ? FindWeightedDirection(normals) : FindVisibleDirection(normals);
  this->MustBeGood[U(v)] = seen.leastCosine >= goodVisibility && leastTriangle >= goodTriangle ? 1 : 0;
  this->C.hidden[U(v)] = seen.leastCosine < leastVisibility ? 1 : 0;
  this->C.direction[U(v)] = seen.direction;
  this->Edge[U(v)] = edges > 0 ? sum / edges : 0;
  const double asked = RoomAbove * this->Options.leastQuality;
  if (this->Options.cells == ColumnCells::Prisms &&
      this->Sight(v, seen.direction) < std::max(enoughGround, asked))
  {
    const VisibleDirection best = FindWeightedDirection(weighted);
    if (best.leastCosine > 0)
    {
      this->C.direction[U(v)] = best.direction;
    }
    const bool isPoor = best.leastCosine < asked;
    this->C.hidden[U(v)] |= isPoor ? this->MustBeGood[U(v)] : 0;
  }
  this->Seen[U(v)] = this->Sight(v, this->C.direction[U(v)]);
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
  this->MustBeGood.assign(count, 0);
  this->Watch.For(static_cast<Id>(count), 512,
                  [&](Id begin, Id end)
                  {
                    for (Id v = begin; v < end; ++v)
                    {
                      this->FindDirection(v);
                    }
                  });
}

/// Neighbouring columns should not cross: take the mean direction of the ring where it still sees all faces
/// nearly as well as the best one does, and well enough.
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
                        const Vec3 mean = Normalized(this->Allowed(v, Normalized(sum) + before[U(v)]));
                        const double sight = this->Sight(v, mean);
                        if (sight >= std::max(0.85 * best[U(v)], std::min(best[U(v)], enoughSight)))
                        {
                          this->C.direction[U(v)] = mean;
                          this->Seen[U(v)] = sight;
                        }
                      }
                    });
  }
}

} // namespace lamina
