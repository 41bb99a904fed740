// SPDX-License-Identifier: BSD-3-Clause
#include "SheetFairing.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>

namespace lamina
{

namespace
{

constexpr double TwoPi = 6.283185307179586;

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

using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor, Id>;

} // namespace

struct SheetFairing::System
{
  Matrix stiffness;     ///< cotangents: minus the integral of the Laplacian around each point
  Eigen::VectorXd area; ///< around each point

  std::vector<double> Solve(Matrix& system, Eigen::VectorXd& right, const std::vector<char>& free) const;
};

SheetFairing::~SheetFairing() = default;

SheetFairing::SheetFairing(const TriangleComplex& surface)
  : Surface(surface)
  , Parts(std::make_unique<System>())
{
  const Id count = static_cast<Id>(surface.points.size());
  this->Parts->area = Eigen::VectorXd::Zero(count);
  std::vector<Eigen::Triplet<double, Id>> entries;
  entries.reserve(12 * surface.triangles.size());
  for (const Triangle& t : surface.triangles)
  {
    const double area = 0.5 * Norm(AreaVector2(surface.points, t));
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Id a = t[i];
      const Id b = t[(i + 1) % 3];
      const Id c = t[(i + 2) % 3];
      const auto x = [&](Id p) { return surface.points[static_cast<std::size_t>(p)]; };
      const double w = 0.5 * Cotangent(x(a), x(b), x(c));
      this->Parts->area[a] += area / 3;
      entries.emplace_back(b, b, w);
      entries.emplace_back(c, c, w);
      entries.emplace_back(b, c, -w);
      entries.emplace_back(c, b, -w);
    }
  }
  this->Parts->stiffness.resize(count, count);
  this->Parts->stiffness.setFromTriplets(entries.begin(), entries.end());
}

/// The solution with all points that are not free at 0; zeros if there is none.
std::vector<double> SheetFairing::System::Solve(Matrix& system, Eigen::VectorXd& right,
                                                const std::vector<char>& free) const
{
  for (Id p = 0; p < right.size(); ++p)
  {
    const bool moves = free[static_cast<std::size_t>(p)] != 0;
    right[p] = moves ? right[p] : 0;
    for (Matrix::InnerIterator it(system, p); it; ++it)
    {
      if (it.col() == p)
      {
        it.valueRef() += std::max(this->area[p], 1e-300);
      }
      else if (!moves || !free[static_cast<std::size_t>(it.col())])
      {
        it.valueRef() = 0;
      }
    }
  }
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(1e-6);
  solver.setMaxIterations(1000);
  solver.compute(system);
  const Eigen::VectorXd solution = solver.solve(right);
  std::vector<double> offsets(free.size(), 0);
  for (Id p = 0; p < right.size(); ++p)
  {
    const bool good = free[static_cast<std::size_t>(p)] != 0 && std::isfinite(solution[p]);
    offsets[static_cast<std::size_t>(p)] = good ? solution[p] : 0;
  }
  return offsets;
}

std::vector<double> SheetFairing::Offsets(const std::vector<Vec3>& normals, const std::vector<char>& free,
                                          double wavelength) const
{
  const Id count = this->Parts->area.size();
  Eigen::VectorXd bending(count); // the area times twice the mean curvature
  for (Id p = 0; p < count; ++p)
  {
    Vec3 sum;
    for (Matrix::InnerIterator it(this->Parts->stiffness, p); it; ++it)
    {
      sum += it.value() * this->Surface.points[static_cast<std::size_t>(it.col())];
    }
    bending[p] = Dot(sum, normals[static_cast<std::size_t>(p)]);
  }
  const Eigen::VectorXd inverse = this->Parts->area.cwiseMax(1e-300).cwiseInverse();
  const double weight = std::pow(wavelength / TwoPi, 4);
  Matrix system = weight * (this->Parts->stiffness * inverse.asDiagonal() * this->Parts->stiffness);
  Eigen::VectorXd right = -weight * (this->Parts->stiffness * inverse.cwiseProduct(bending));
  return this->Parts->Solve(system, right, free);
}

std::vector<double> SheetFairing::Spread(const std::vector<double>& volumes, const std::vector<char>& free,
                                         double distance) const
{
  Matrix system = (distance * distance) * this->Parts->stiffness;
  // No flux to points that stay: what they would take has to stay with the others.
  for (Id p = 0; p < system.rows(); ++p)
  {
    double& diagonal = system.coeffRef(p, p);
    for (Matrix::InnerIterator it(system, p); it; ++it)
    {
      diagonal += it.col() != p && !free[static_cast<std::size_t>(it.col())] ? it.value() : 0;
    }
  }
  Eigen::VectorXd right = Eigen::Map<const Eigen::VectorXd>(volumes.data(), static_cast<Id>(volumes.size()));
  return this->Parts->Solve(system, right, free);
}

double SheetFairing::AreaOf(Id p) const
{
  return this->Parts->area[p];
}

} // namespace lamina
