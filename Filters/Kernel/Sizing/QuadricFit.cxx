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
/// Where weights reach zero, in units of the reach.
constexpr double Rim = 1.1;
/// Circles are not followed beyond this share of their radius.
constexpr double MostBend = 0.9;
/// Distances from the fit that count as usual: this many medians, which are at least this share of the reach.
constexpr double Tolerated = 3;
constexpr double LeastResidual = 1e-6;

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// In units of the reach, from the point that is fitted.
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

/// Height over the tangent plane: a + b u + c v + d u^2 / 2 + e u v + f v^2 / 2, in units of the reach.
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

/// One fit after another to the same points, in lengths of `reach`, which keeps the normal equations well
/// conditioned.
class Fitter
{
public:
  Fitter(const SheetStencil& around, const Vec3& centre, double reach, QuadricScratch& scratch)
    : Samples(scratch.samples)
    , Residuals(scratch.residuals)
  {
    this->Samples.clear();
    for (std::size_t i = 0; i < around.Count(); ++i)
    {
      const Vec3 place = (around.Point(i) - centre) * (1 / reach);
      const double taper = 1 - Norm2(place) / (Rim * Rim);
      if (taper > 0)
      {
        this->Samples.push_back({ place, Normalized(around.Normal(i)), taper });
        this->Normal += taper * around.Normal(i);
      }
    }
    this->Normal = Normalized(this->Normal);
  }

  /// Coordinates in the frame; points that face away from it do not count (Jiao and Zha).
  void SetFrame(const Frame& frame)
  {
    for (QuadricSample& s : this->Samples)
    {
      const Vec3 d = s.place - frame.origin;
      s.x = Dot(d, frame.u);
      s.y = Dot(d, frame.v);
      s.height = Dot(d, frame.normal);
      s.weight = s.taper * std::max(0.0, Dot(s.normal, frame.normal));
    }
  }

  /// Weighted least squares.
  Quadric Fit(const Quadric& known) const
  {
    Matrix6 matrix = Matrix6::Zero();
    Vector6 right = Vector6::Zero();
    for (const QuadricSample& s : this->Samples)
    {
      const double r2 = s.x * s.x + s.y * s.y;
      const double bend = r2 > 0 ? known.Bend(s.x, s.y) / r2 : 0;
      Vector6 row;
      row << 1, s.x, s.y, 0.5 * s.x * s.x, s.x * s.y, 0.5 * s.y * s.y;
      const Vector6 weighted = (s.trust * s.weight) * row;
      matrix.noalias() += weighted * row.transpose();
      right += (s.height - CircleOverParabola(bend, r2)) * weighted;
    }
    return { Solve(matrix, right) };
  }

  /// Points far off the fit, measured by the median, are spikes that smoothing has left: they lose weight
  /// (Geman and McClure's function), so that a few of them do not bend the fit.
  void Doubt(const Quadric& quadric)
  {
    this->Residuals.clear();
    for (const QuadricSample& s : this->Samples)
    {
      this->Residuals.push_back(std::abs(s.height - quadric.At(s.x, s.y)));
    }
    const auto middle = this->Residuals.begin() + static_cast<std::ptrdiff_t>(this->Residuals.size() / 2);
    std::nth_element(this->Residuals.begin(), middle, this->Residuals.end());
    const double usual = Tolerated * std::max(*middle, LeastResidual);
    for (QuadricSample& s : this->Samples)
    {
      const double excess = (s.height - quadric.At(s.x, s.y)) / usual;
      s.trust = 1 / ((1 + excess * excess) * (1 + excess * excess));
    }
  }

  Vec3 Normal; ///< the mean one, a first guess

private:
  std::vector<QuadricSample>& Samples;
  std::vector<double>& Residuals;
};

} // namespace

PointCurvature FitQuadric(const SheetStencil& around, const Vec3& centre, double reach,
                          QuadricScratch& scratch)
{
  Fitter fitter(around, centre, reach, scratch);
  if (Norm2(fitter.Normal) == 0)
  {
    return {};
  }
  // A first fit finds the tangent plane; in it, the last one takes off what circles rise above parabolas.
  Frame frame = MakeFrame({}, fitter.Normal);
  fitter.SetFrame(frame);
  Quadric quadric = fitter.Fit(Quadric{});
  fitter.Doubt(quadric);
  const Vec3 fitted = Normalized(frame.normal - quadric.c[1] * frame.u - quadric.c[2] * frame.v);
  frame = MakeFrame(quadric.c[0] * frame.normal, fitted);
  fitter.SetFrame(frame);
  quadric = fitter.Fit(Quadric{});
  fitter.Doubt(quadric);
  quadric = fitter.Fit(quadric);
  return Principal(frame, quadric, reach);
}

} // namespace lamina
