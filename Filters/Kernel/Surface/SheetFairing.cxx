// SPDX-License-Identifier: BSD-3-Clause
#include "SheetFairing.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

namespace
{

constexpr double TwoPi = 6.283185307179586;
constexpr Id Block = 8192; ///< points that are summed in one go
constexpr double tolerance = 1e-4;
constexpr int mostIterations = 1000;

/// Cotangents beyond these belong to triangles too thin to tell a curvature.
constexpr double LeastCotangent = 0.0;
constexpr double GreatestCotangent = 4;

/// The cotangent of the angle at a.
double Cotangent(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const double sine = Norm(Cross(b - a, c - a));
  const double value = Dot(b - a, c - a) / std::max(sine, 1e-300);
  return std::min(GreatestCotangent, std::max(LeastCotangent, value));
}

} // namespace

// Templates, as they visit every point in every step of the conjugate gradients.
template<typename Visit>
void SheetFairing::ForPoints(const Visit& visit) const
{
  this->Watch.For(static_cast<Id>(this->State.surface.points.size()), Block,
                  [&](Id begin, Id end)
                  {
                    for (Id p = begin; p < end; ++p)
                    {
                      visit(static_cast<std::size_t>(p));
                    }
                  });
}

template<typename Term>
double SheetFairing::Sum(const Term& term) const
{
  const Id count = static_cast<Id>(this->State.surface.points.size());
  const Id blocks = (count + Block - 1) / Block;
  Vector sums(static_cast<std::size_t>(blocks), 0);
  this->Watch.For(blocks, 1,
                  [&](Id begin, Id end)
                  {
                    for (Id b = begin; b < end; ++b)
                    {
                      double sum = 0;
                      for (Id p = b * Block; p < std::min(count, (b + 1) * Block); ++p)
                      {
                        sum += term(static_cast<std::size_t>(p));
                      }
                      sums[static_cast<std::size_t>(b)] = sum;
                    }
                  });
  double all = 0;
  for (const double sum : sums)
  {
    all += sum;
  }
  return all;
}

SheetFairing::SheetFairing(const SmoothingState& state, Monitor& monitor)
  : State(state)
  , Watch(monitor)
  , Beside(state.ring.data.size(), 0)
  , Diagonal(state.surface.points.size(), 0)
  , Area(state.surface.points.size(), 0)
{
  this->ForPoints([this](std::size_t p) { this->FillRow(static_cast<Id>(p)); });
}

void SheetFairing::FillRow(Id p)
{
  const std::vector<Vec3>& points = this->State.surface.points;
  const auto x = [&](Id q) { return points[static_cast<std::size_t>(q)]; };
  const ListRow ring = Row(this->State.ring, p);
  double* entries = this->Beside.data() + this->State.ring.offsets[static_cast<std::size_t>(p)];
  const auto add = [&](Id q, double weight)
  {
    entries[std::lower_bound(ring.begin(), ring.end(), q) - ring.begin()] -= weight;
    this->Diagonal[static_cast<std::size_t>(p)] += weight;
  };
  for (const Id triangle : Row(this->State.star, p))
  {
    const Triangle& t = this->State.surface.triangles[static_cast<std::size_t>(triangle)];
    const std::size_t at = t[0] == p ? 0 : (t[1] == p ? 1 : 2);
    const Id q = t[(at + 1) % 3];
    const Id r = t[(at + 2) % 3];
    add(q, 0.5 * Cotangent(x(r), x(p), x(q)));
    add(r, 0.5 * Cotangent(x(q), x(r), x(p)));
    this->Area[static_cast<std::size_t>(p)] += Norm(AreaVector2(points, t)) / 6;
  }
}

double SheetFairing::Stiff(const Vector& x, std::size_t p) const
{
  const Lists& ring = this->State.ring;
  double sum = this->Diagonal[p] * x[p];
  for (auto n = static_cast<std::size_t>(ring.offsets[p]); n < static_cast<std::size_t>(ring.offsets[p + 1]);
       ++n)
  {
    sum += this->Beside[n] * x[static_cast<std::size_t>(ring.data[n])];
  }
  return sum;
}

/// Conjugate gradients with the diagonal as preconditioner; where `diagonal` is 0 the solution is.
SheetFairing::Vector SheetFairing::Solve(const Apply& apply, const Vector& diagonal,
                                         const Vector& right) const
{
  const std::size_t count = right.size();
  Vector x(count, 0);
  Vector rest = right;
  Vector direction(count, 0);
  Vector image(count, 0);
  const auto scaled = [&](std::size_t p) { return diagonal[p] > 0 ? rest[p] / diagonal[p] : 0; };
  const double goal = tolerance * tolerance * this->Sum([&](std::size_t p) { return right[p] * right[p]; });
  this->ForPoints([&](std::size_t p) { direction[p] = scaled(p); });
  double old = this->Sum([&](std::size_t p) { return rest[p] * scaled(p); });
  for (int i = 0; i < mostIterations && old > 0 && !this->Watch.Cancelled(); ++i)
  {
    apply(direction, image);
    const double bend = this->Sum([&](std::size_t p) { return direction[p] * image[p]; });
    if (!(bend > 0) || !std::isfinite(bend))
    {
      break;
    }
    const double step = old / bend;
    const double left = this->Sum(
      [&](std::size_t p)
      {
        x[p] += step * direction[p];
        rest[p] -= step * image[p];
        return rest[p] * rest[p];
      });
    if (!(left > goal))
    {
      break;
    }
    const double now = this->Sum([&](std::size_t p) { return rest[p] * scaled(p); });
    const double back = now / old;
    old = now;
    this->ForPoints([&](std::size_t p) { direction[p] = scaled(p) + back * direction[p]; });
  }
  this->ForPoints([&](std::size_t p) { x[p] = std::isfinite(x[p]) ? x[p] : 0; });
  return x;
}

std::vector<double> SheetFairing::Offsets(const std::vector<Vec3>& normals, const std::vector<char>& free,
                                          double wavelength) const
{
  const std::size_t count = this->Area.size();
  const std::vector<Vec3>& points = this->State.surface.points;
  const Lists& ring = this->State.ring;
  const double weight = std::pow(wavelength / TwoPi, 4);
  const auto inverse = [this](std::size_t p) { return 1 / std::max(this->Area[p], 1e-300); };
  Vector curved(count); // twice the mean curvature
  this->ForPoints(
    [&](std::size_t p)
    {
      Vec3 sum = this->Diagonal[p] * points[p];
      for (auto n = static_cast<std::size_t>(ring.offsets[p]);
           n < static_cast<std::size_t>(ring.offsets[p + 1]); ++n)
      {
        sum += this->Beside[n] * points[static_cast<std::size_t>(ring.data[n])];
      }
      curved[p] = inverse(p) * Dot(sum, normals[p]);
    });
  Vector right(count);
  Vector diagonal(count);
  this->ForPoints(
    [&](std::size_t p)
    {
      right[p] = free[p] ? -weight * this->Stiff(curved, p) : 0;
      double sum = this->Diagonal[p] * this->Diagonal[p] * inverse(p);
      for (auto n = static_cast<std::size_t>(ring.offsets[p]);
           n < static_cast<std::size_t>(ring.offsets[p + 1]); ++n)
      {
        sum += this->Beside[n] * this->Beside[n] * inverse(static_cast<std::size_t>(ring.data[n]));
      }
      diagonal[p] = free[p] ? this->Area[p] + weight * sum : 0;
    });
  Vector middle(count);
  const auto apply = [&](const Vector& x, Vector& y)
  {
    this->ForPoints([&](std::size_t p) { middle[p] = inverse(p) * this->Stiff(x, p); });
    this->ForPoints([&](std::size_t p)
                    { y[p] = free[p] ? this->Area[p] * x[p] + weight * this->Stiff(middle, p) : 0; });
  };
  return this->Solve(apply, diagonal, right);
}

std::vector<double> SheetFairing::Spread(const std::vector<double>& volumes, const std::vector<char>& free,
                                         double distance) const
{
  const std::size_t count = this->Area.size();
  const Lists& ring = this->State.ring;
  const double weight = distance * distance;
  Vector right(count);
  Vector diagonal(count);
  // No flux to points that stay: what they would take has to stay with the others.
  this->ForPoints(
    [&](std::size_t p)
    {
      double sum = this->Diagonal[p];
      for (auto n = static_cast<std::size_t>(ring.offsets[p]);
           n < static_cast<std::size_t>(ring.offsets[p + 1]); ++n)
      {
        sum += free[static_cast<std::size_t>(ring.data[n])] ? 0 : this->Beside[n];
      }
      right[p] = free[p] ? volumes[p] : 0;
      diagonal[p] = free[p] ? this->Area[p] + weight * sum : 0;
    });
  const auto apply = [&](const Vector& x, Vector& y)
  {
    // x is 0 where points stay, so their entries of the stiffness add nothing.
    this->ForPoints(
      [&](std::size_t p)
      { y[p] = free[p] ? diagonal[p] * x[p] + weight * (this->Stiff(x, p) - this->Diagonal[p] * x[p]) : 0; });
  };
  return this->Solve(apply, diagonal, right);
}

} // namespace lamina
