// SPDX-License-Identifier: BSD-3-Clause
#include "QuadraticCells.h"

#include <Eigen/Dense>

#include <algorithm>

namespace lamina
{
namespace
{

double Determinant(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return Dot(Cross(a, b), c);
}

using Degrees = std::array<int, 4>;

double Factorial(int n)
{
  return n < 2 ? 1.0 : n * Factorial(n - 1);
}

/// Exponents of the barycentric coordinates of Bernstein polynomials of `degree`.
template<std::size_t Corners>
std::vector<std::array<int, Corners>> Exponents(int degree)
{
  std::vector<std::array<int, Corners>> all;
  std::array<int, Corners> e{};
  const auto fill = [&](auto&& self, std::size_t at, int left) -> void
  {
    if (at + 1 == Corners)
    {
      e[at] = left;
      all.push_back(e);
      return;
    }
    for (int k = 0; k <= left; ++k)
    {
      e[at] = k;
      self(self, at + 1, left - k);
    }
  };
  fill(fill, 0, degree);
  return all;
}

template<std::size_t Corners>
double Bernstein(const std::array<int, Corners>& e, int degree, const std::array<double, Corners>& at)
{
  double value = Factorial(degree);
  for (std::size_t k = 0; k < Corners; ++k)
  {
    value *= std::pow(at[k], e[k]) / Factorial(e[k]);
  }
  return value;
}

constexpr int WedgeDegree = 4;
constexpr int WedgeHeight = 5;

/// Where a wedge's Jacobian is taken, and the matrix that makes coefficients of the values.
struct WedgeBasis
{
  std::vector<std::array<double, 3>> places;
  Eigen::MatrixXd toCoefficients;

  WedgeBasis()
  {
    const auto across = Exponents<3>(WedgeDegree);
    const auto along = Exponents<2>(WedgeHeight);
    for (const auto& a : across)
    {
      for (const auto& h : along)
      {
        this->places.push_back(
          { { a[1] / double(WedgeDegree), a[2] / double(WedgeDegree), h[1] / double(WedgeHeight) } });
      }
    }
    const auto n = static_cast<Eigen::Index>(this->places.size());
    Eigen::MatrixXd values(n, n);
    for (Eigen::Index row = 0; row < n; ++row)
    {
      const auto& [r, s, t] = this->places[static_cast<std::size_t>(row)];
      Eigen::Index column = 0;
      for (const auto& a : across)
      {
        for (const auto& h : along)
        {
          values(row, column++) = Bernstein<3>(a, WedgeDegree, { { 1 - r - s, r, s } }) *
                                  Bernstein<2>(h, WedgeHeight, { { 1 - t, t } });
        }
      }
    }
    this->toCoefficients = values.inverse();
  }
};

} // namespace

std::array<double, 20> QuadraticTetJacobian(const std::array<Vec3, 10>& nodes)
{
  // Bezier points of the map, of degree 2: corners, and 2 m - (a + b) / 2 on the edges. Derivatives along an
  // edge direction are linear: their coefficients are twice the differences of Bezier points.
  constexpr int edges[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
  std::array<std::array<Vec3, 4>, 4> bezier;
  for (std::size_t k = 0; k < 4; ++k)
  {
    bezier[k][k] = nodes[k];
  }
  for (std::size_t e = 0; e < 6; ++e)
  {
    const auto a = static_cast<std::size_t>(edges[e][0]);
    const auto b = static_cast<std::size_t>(edges[e][1]);
    bezier[a][b] = bezier[b][a] = 2.0 * nodes[4 + e] - 0.5 * (nodes[a] + nodes[b]);
  }
  const auto derivative = [&](std::size_t along, std::size_t at)
  { return 2.0 * (bezier[at][along] - bezier[at][0]); };
  const auto exponents = Exponents<4>(3);
  std::array<double, 20> coefficients{};
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t j = 0; j < 4; ++j)
    {
      for (std::size_t k = 0; k < 4; ++k)
      {
        // The product of three linear Bernstein polynomials is one of degree 3, weighted by its multiplicity.
        Degrees e{};
        ++e[i];
        ++e[j];
        ++e[k];
        const auto at =
          static_cast<std::size_t>(std::find(exponents.begin(), exponents.end(), e) - exponents.begin());
        const double multiplicity =
          6 / (Factorial(e[0]) * Factorial(e[1]) * Factorial(e[2]) * Factorial(e[3]));
        coefficients[at] += Determinant(derivative(1, i), derivative(2, j), derivative(3, k)) / multiplicity;
      }
    }
  }
  return coefficients;
}

bool QuadraticTetIsValid(const std::array<Vec3, 10>& nodes)
{
  const auto coefficients = QuadraticTetJacobian(nodes);
  return std::all_of(coefficients.begin(), coefficients.end(), [](double c) { return c > 0; });
}

double QuadraticWedgeJacobian(const std::array<Vec3, 15>& nodes, double r, double s, double t)
{
  const std::array<double, 3> area{ { 1 - r - s, r, s } };
  const std::array<Vec3, 3> areaGradient{ { { -1, -1, 0 }, { 1, 0, 0 }, { 0, 1, 0 } } };
  const std::array<double, 2> end{ { 1 - t, t } };
  const std::array<double, 2> endSlope{ { -1, 1 } };
  std::array<Vec3, 3> columns;
  const auto add = [&](std::size_t node, const Vec3& inPlane, double along)
  {
    columns[0] += nodes[node] * inPlane.x;
    columns[1] += nodes[node] * inPlane.y;
    columns[2] += nodes[node] * along;
  };
  for (std::size_t h = 0; h < 2; ++h)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      // A corner: L (2 L + 2 e - 3) e, e the share of its end; the middle of an edge of the triangle: 4 L M
      // e.
      const double l = area[k];
      const double e = end[h];
      const double factor = 2 * l + 2 * e - 3;
      add(3 * h + k, areaGradient[k] * (e * (factor + 2 * l)), endSlope[h] * l * (factor + 2 * e));
      const std::size_t next = (k + 1) % 3;
      add(6 + 3 * h + k, (areaGradient[k] * area[next] + areaGradient[next] * l) * (4 * e),
          endSlope[h] * 4 * l * area[next]);
    }
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    add(12 + k, areaGradient[k] * (4 * t * (1 - t)), area[k] * 4 * (1 - 2 * t));
  }
  return -Determinant(columns[0], columns[1], columns[2]); // the first triangle looks outwards
}

bool QuadraticWedgeIsValid(const std::array<Vec3, 15>& nodes)
{
  static const WedgeBasis basis;
  Eigen::VectorXd values(static_cast<Eigen::Index>(basis.places.size()));
  for (std::size_t i = 0; i < basis.places.size(); ++i)
  {
    const auto& [r, s, t] = basis.places[i];
    values(static_cast<Eigen::Index>(i)) = QuadraticWedgeJacobian(nodes, r, s, t);
  }
  // The values' own rounding, magnified by the basis, must not pass for a positive coefficient.
  const double noise = 1e-10 * values.cwiseAbs().maxCoeff();
  return (basis.toCoefficients * values).minCoeff() > noise;
}

} // namespace lamina
