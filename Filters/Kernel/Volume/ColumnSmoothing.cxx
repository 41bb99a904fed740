// SPDX-License-Identifier: BSD-3-Clause
// Variational smoothing of the front: tops move along it to where its triangles are best shaped and columns
// stand upright, as far as no prism around becomes worse.
#include "ColumnGrowth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamina
{

namespace
{

constexpr int Sweeps = 3;
constexpr double UprightWeight = 0.5; ///< of upright columns against well shaped triangles
constexpr double LongestStep = 0.25;  ///< of the shortest edge at the top
constexpr double Probe = 1e-3;        ///< of that edge, for slopes
constexpr int MostHalvings = 3;
constexpr double LeastDrop = 1e-3; ///< of the energy, relative: less is no gain
constexpr double FlatEnough = 0.6; ///< least cosine between the front's normals at a point and their mean
constexpr double GoodEnough = 0.6; ///< prisms from here on may be bettered at the cost of each other

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

/// Sum of squared edges over area: 1 for an equilateral triangle. Infinite for one that is turned over.
double ShapeEnergy(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& up)
{
  constexpr double ideal = 0.28867513459481287; // 1 / (2 sqrt 3), with twice the area
  const Vec3 area = Cross(b - a, c - a);
  const double edges = Norm2(b - a) + Norm2(c - b) + Norm2(a - c);
  return Dot(area, up) > 0 ? ideal * edges / Norm(area) : std::numeric_limits<double>::infinity();
}

/// One over the squared sine of the angle between a side and an edge.
double UprightEnergy(const Vec3& side, const Vec3& edge)
{
  const double sine = Norm2(Cross(side, edge));
  return sine > 0 ? Norm2(side) * Norm2(edge) / sine : std::numeric_limits<double>::infinity();
}

} // namespace

/// Of the front's triangles at the top of a column that runs along `offset`, and of its angles with the edges
/// at both its ends.
double ColumnGrowth::FrontEnergy(Id v, const Vec3& offset) const
{
  const Vec3& foot = this->W.points[U(v)];
  const Vec3 top = foot + offset;
  double sum = 0;
  for (Id t : Row(this->W.star, v))
  {
    const Triangle& c = this->W.triangles[U(t)];
    const std::size_t k = c[0] == v ? 0 : (c[1] == v ? 1 : 2);
    const Id p = c[(k + 1) % 3];
    const Id q = c[(k + 2) % 3];
    const Vec3 one = this->C.Place(this->W, p, this->C.layers);
    const Vec3 two = this->C.Place(this->W, q, this->C.layers);
    sum += ShapeEnergy(top, one, two, this->Normals[U(t)]);
    // Each edge is met twice, so its two columns and both its ends come to once each.
    for (const auto& [next, place] : { std::make_pair(p, one), std::make_pair(q, two) })
    {
      sum += 0.5 * UprightWeight *
             (UprightEnergy(offset, place - top) + UprightEnergy(offset, this->W.points[U(next)] - foot));
      if (!this->C.Stopped(next))
      {
        sum += 0.5 * UprightWeight * UprightEnergy(place - this->W.points[U(next)], top - place);
      }
    }
  }
  return sum;
}

/// Newton's step in the plane spanned by `frame`, or downhill where the energy is not convex.
Vec3 ColumnGrowth::FrontStep(Id v, const Vec3& offset, const std::array<Vec3, 2>& frame, double edge) const
{
  const double h = Probe * edge;
  const auto at = [&](double i, double j)
  { return this->FrontEnergy(v, offset + (i * h) * frame[0] + (j * h) * frame[1]); };
  const double here = at(0, 0);
  const double east = at(1, 0);
  const double west = at(-1, 0);
  const double north = at(0, 1);
  const double south = at(0, -1);
  const double gx = (east - west) / (2 * h);
  const double gy = (north - south) / (2 * h);
  const double xx = (east - 2 * here + west) / (h * h);
  const double yy = (north - 2 * here + south) / (h * h);
  const double xy = (at(1, 1) - east - north + here) / (h * h);
  const double determinant = xx * yy - xy * xy;
  Vec3 step = -gx * frame[0] - gy * frame[1];
  if (xx > 0 && determinant > 1e-6 * xx * yy)
  {
    step = ((xy * gy - yy * gx) / determinant) * frame[0] + ((xy * gx - xx * gy) / determinant) * frame[1];
  }
  const double length = Norm(step);
  return std::isfinite(length) && length > LongestStep * edge ? step * (LongestStep * edge / length) : step;
}

bool ColumnGrowth::SmoothTop(Id v)
{
  Vec3 up;
  std::vector<Vec3> normals;
  double edge = std::numeric_limits<double>::infinity();
  const Vec3 top = this->C.Place(this->W, v, this->C.layers);
  for (Id t : Row(this->W.star, v))
  {
    const Triangle& c = this->W.triangles[U(t)];
    std::array<Vec3, 3> places;
    for (std::size_t k = 0; k < 3; ++k)
    {
      places[k] = this->C.Place(this->W, c[k], this->C.layers);
      edge = c[k] == v ? edge : std::min(edge, Norm(places[k] - top));
    }
    normals.push_back(Cross(places[1] - places[0], places[2] - places[0]));
    up += normals.back();
  }
  // At folds and necks of the front the core has little room: to move there is not the prisms' matter alone.
  if (std::any_of(normals.begin(), normals.end(),
                  [&](const Vec3& n) { return Dot(n, up) < FlatEnough * Norm(n) * Norm(up); }))
  {
    return false;
  }
  const Vec3 offset = this->C.height[U(v)] * this->C.direction[U(v)];
  const double before = this->FrontEnergy(v, offset);
  if (!(Norm(up) > 0 && edge > 0 && std::isfinite(before)))
  {
    return false;
  }
  Vec3 step = this->FrontStep(v, offset, FrameOf(Normalized(up)), edge);
  const double worst = this->WorstAround(v, -1e30, GoodEnough);
  Vec3& direction = this->C.direction[U(v)];
  const Vec3 old = direction;
  for (int halving = 0; halving < MostHalvings && std::isfinite(Norm(step)); step = 0.5 * step, ++halving)
  {
    const Vec3 turned = Normalized(this->Allowed(v, offset + step));
    if (!(this->FrontEnergy(v, this->C.height[U(v)] * turned) < (1 - LeastDrop) * before) ||
        !(this->Sight(v, turned) > 0))
    {
      continue;
    }
    direction = turned;
    if (this->WorstAround(v, -1e30, GoodEnough) >= worst)
    {
      return true;
    }
    direction = old;
  }
  return false;
}

Id ColumnGrowth::SmoothFront()
{
  std::vector<Id> nodes = this->PoorColumns(GoodEnough);
  std::vector<std::vector<Id>> colours;
  while (!nodes.empty())
  {
    colours.push_back(this->TakeApart(nodes));
  }
  Id moved = 0;
  for (int sweep = 0; sweep < Sweeps && !this->Watch.Cancelled(); ++sweep)
  {
    for (const std::vector<Id>& apart : colours)
    {
      std::vector<char> changed(apart.size(), 0);
      this->Watch.For(static_cast<Id>(apart.size()), 32,
                      [&](Id begin, Id end)
                      {
                        for (Id i = begin; i < end; ++i)
                        {
                          changed[U(i)] = this->SmoothTop(apart[U(i)]) ? 1 : 0;
                        }
                      });
      moved += std::count(changed.begin(), changed.end(), 1);
    }
  }
  return moved;
}

} // namespace lamina
