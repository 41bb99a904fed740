// SPDX-License-Identifier: BSD-3-Clause
#include "QuadricFit.h"

#include <Eigen/Dense>

#include <algorithm>

namespace lamina
{
namespace
{

/// Pivots of the scaled normal equations below this share of the largest: directions without data.
constexpr double LeastPivot = 1e-9;
/// Circles are not followed beyond this share of their radius.
constexpr double MostBend = 0.9;
/// Distances from the fit that count as usual: this many medians, which are at least this share of the reach.
constexpr double Tolerated = 3;
constexpr double LeastResidual = 1e-6;

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

struct Frame
{
  Vec3 origin;
  Vec3 u;
  Vec3 v;
  Vec3 normal;
};

Frame MakeFrame(const Vec3& origin, const Vec3& normal)
{
  const Vec3 a{ std::abs(normal.x), std::abs(normal.y), std::abs(normal.z) };
  const Vec3 axis =
    a.x <= a.y && a.x <= a.z ? Vec3{ 1, 0, 0 } : (a.y <= a.z ? Vec3{ 0, 1, 0 } : Vec3{ 0, 0, 1 });
  const Vec3 u = Normalized(Cross(normal, axis));
  return { origin, u, Cross(normal, u), normal };
}

/// Height over the tangent plane: a + b u + c v + d u^2 / 2 + e u v + f v^2 / 2, in units of `scale`.
struct Quadric
{
  Vector6 c = Vector6::Zero();

  double At(double x, double y) const
  {
    return this->c[0] + this->c[1] * x + this->c[2] * y + 0.5 * (this->c[3] * x * x + this->c[5] * y * y) +
           this->c[4] * x * y;
  }
  /// The second derivative along the unit direction (x, y).
  double Bend(double x, double y) const
  {
    return this->c[3] * x * x + 2 * this->c[4] * x * y + this->c[5] * y * y;
  }
};

/// What a circle of curvature k, tangent to the plane, rises more than its parabola at distance r.
double CircleOverParabola(double k, double r2)
{
  const double bend2 = std::min(k * k * r2, MostBend * MostBend);
  return k * r2 * (1 / (1 + std::sqrt(1 - bend2)) - 0.5);
}

double Taper(double distance2, double reach)
{
  const double rest = 1 - distance2 / (1.21 * reach * reach);
  return rest > 0 ? rest : 0;
}

Vector6 Solve(const Matrix6& matrix, const Vector6& right)
{
  const Eigen::LDLT<Matrix6> factors(matrix);
  const Vector6 pivots = factors.vectorD();
  if (factors.info() == Eigen::Success && pivots.minCoeff() > LeastPivot * pivots.maxCoeff())
  {
    return factors.solve(right);
  }
  // Too few points or all in a row: what they do not tell stays zero.
  Eigen::CompleteOrthogonalDecomposition<Matrix6> orthogonal;
  orthogonal.setThreshold(std::sqrt(LeastPivot));
  orthogonal.compute(matrix);
  return orthogonal.solve(right);
}

/// From the symmetric shape operator of the quadric at its origin (Jiao and Zha).
PointCurvature Principal(const Frame& frame, const Quadric& quadric, double reach)
{
  const Vector6& c = quadric.c;
  const double slope = std::hypot(c[1], c[2]);
  const double l = std::hypot(1, slope);
  const double cosine = slope > 0 ? c[1] / slope : 1;
  const double sine = slope > 0 ? c[2] / slope : 0;
  Eigen::Matrix2d hessian;
  hessian << c[3], c[4], c[4], c[5];
  Eigen::Matrix2d turn;
  turn << cosine / l, sine / l, -sine, cosine;
  // Heights fall where the surface bends away from its normal.
  const Eigen::Matrix2d shape = (-1 / (l * reach)) * (turn * hessian * turn.transpose());
  const double mean = 0.5 * (shape(0, 0) + shape(1, 1));
  const double half = 0.5 * (shape(0, 0) - shape(1, 1));
  const double spread = std::hypot(half, shape(0, 1));
  const double angle = 0.5 * std::atan2(shape(0, 1), half);
  const Vec3 along = (1 / l) * (cosine * frame.u + sine * frame.v + slope * frame.normal);
  const Vec3 across = cosine * frame.v - sine * frame.u;
  return { mean + spread, mean - spread, Normalized(std::cos(angle) * along + std::sin(angle) * across) };
}

/// One fit after another to the same points.
class Fitter
{
public:
  Fitter(const SheetStencil& around, QuadricScratch& scratch)
    : Around(around)
    , Trust(scratch.trust)
    , Residuals(scratch.residuals)
    , Sorted(scratch.sorted)
  {
    this->Trust.assign(around.Count(), 1);
  }

  Vec3 MeanNormal(const Vec3& centre, double reach) const
  {
    Vec3 sum;
    for (std::size_t i = 0; i < this->Around.Count(); ++i)
    {
      sum += Taper(Norm2(this->Around.Point(i) - centre), reach) * this->Around.Normal(i);
    }
    return Normalized(sum);
  }

  /// Weighted least squares in lengths of `reach`, which keeps the normal equations well conditioned.
  Quadric Fit(const Frame& frame, double reach, const Quadric& known) const
  {
    Matrix6 matrix = Matrix6::Zero();
    Vector6 right = Vector6::Zero();
    for (std::size_t i = 0; i < this->Around.Count(); ++i)
    {
      const Vec3 d = (this->Around.Point(i) - frame.origin) * (1 / reach);
      const double facing = Dot(Normalized(this->Around.Normal(i)), frame.normal);
      const double weight = this->Trust[i] * Taper(Norm2(d), 1) * std::max(0.0, facing);
      if (weight > 0)
      {
        const double x = Dot(d, frame.u);
        const double y = Dot(d, frame.v);
        const double r2 = x * x + y * y;
        const double bend = r2 > 0 ? known.Bend(x, y) / r2 : 0;
        Vector6 row;
        row << 1, x, y, 0.5 * x * x, x * y, 0.5 * y * y;
        matrix.selfadjointView<Eigen::Lower>().rankUpdate(row, weight);
        right += (weight * (Dot(d, frame.normal) - CircleOverParabola(bend, r2))) * row;
      }
    }
    matrix = matrix.selfadjointView<Eigen::Lower>();
    return { Solve(matrix, right) };
  }

  /// Points far off the fit, measured by the median, are spikes that smoothing has left: they lose weight
  /// (Geman and McClure's function), so that a few of them do not bend the fit.
  void Doubt(const Frame& frame, double reach, const Quadric& quadric)
  {
    this->Residuals.clear();
    for (std::size_t i = 0; i < this->Around.Count(); ++i)
    {
      const Vec3 d = (this->Around.Point(i) - frame.origin) * (1 / reach);
      this->Residuals.push_back(
        std::abs(Dot(d, frame.normal) - quadric.At(Dot(d, frame.u), Dot(d, frame.v))));
    }
    this->Sorted = this->Residuals;
    const auto middle = this->Sorted.begin() + static_cast<std::ptrdiff_t>(this->Sorted.size() / 2);
    std::nth_element(this->Sorted.begin(), middle, this->Sorted.end());
    const double usual = Tolerated * std::max(*middle, LeastResidual);
    for (std::size_t i = 0; i < this->Residuals.size(); ++i)
    {
      const double excess = this->Residuals[i] / usual;
      this->Trust[i] = 1 / ((1 + excess * excess) * (1 + excess * excess));
    }
  }

private:
  const SheetStencil& Around;
  std::vector<double>& Trust; ///< weight of each point for lying near the fit
  std::vector<double>& Residuals;
  std::vector<double>& Sorted;
};

} // namespace

PointCurvature FitQuadric(const SheetStencil& around, const Vec3& centre, double reach,
                          QuadricScratch& scratch)
{
  Fitter fitter(around, scratch);
  const Vec3 normal = fitter.MeanNormal(centre, reach);
  if (Norm2(normal) == 0)
  {
    return {};
  }
  // A first fit finds the tangent plane; in it, the last one takes off what circles rise above parabolas.
  Frame frame = MakeFrame(centre, normal);
  Quadric quadric = fitter.Fit(frame, reach, Quadric{});
  fitter.Doubt(frame, reach, quadric);
  const double a = quadric.c[0];
  const Vec3 fitted = Normalized(frame.normal - quadric.c[1] * frame.u - quadric.c[2] * frame.v);
  frame = MakeFrame(centre + (a * reach) * frame.normal, fitted);
  quadric = fitter.Fit(frame, reach, Quadric{});
  fitter.Doubt(frame, reach, quadric);
  quadric = fitter.Fit(frame, reach, quadric);
  return Principal(frame, quadric, reach);
}

} // namespace lamina
