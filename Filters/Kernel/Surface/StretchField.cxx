// SPDX-License-Identifier: BSD-3-Clause
#include "StretchField.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace lamina
{

namespace
{

constexpr int rounds = 8; ///< of averaging
constexpr Id grain = 4096;

/// xx, yy, zz, xy, yz, zx: averages of directions that have no sign.
using Tensor = std::array<double, 6>;

Tensor Square(const Vec3& s)
{
  return { { s.x * s.x, s.y * s.y, s.z * s.z, s.x * s.y, s.y * s.z, s.z * s.x } };
}

/// The vector whose square is nearest to t.
Vec3 Root(const Tensor& t)
{
  Eigen::Matrix3d m;
  m << t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2];
  if (m.isZero(0))
  {
    return {};
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
  // What the second direction has as well is no preference.
  const double amount = solver.eigenvalues()[2] - solver.eigenvalues()[1];
  const Eigen::Vector3d axis = solver.eigenvectors().col(2) * std::sqrt(std::max(0.0, amount));
  return { axis[0], axis[1], axis[2] };
}

Stretch StretchOf(const TriangleComplex& surface, std::size_t p, const Vec3& normal, double most)
{
  const double across =
    std::max(std::abs(surface.maximumCurvature[p]), std::abs(surface.minimumCurvature[p]));
  const double along = std::min(std::abs(surface.maximumCurvature[p]), std::abs(surface.minimumCurvature[p]));
  const bool maximumIsAcross = std::abs(surface.maximumCurvature[p]) >= std::abs(surface.minimumCurvature[p]);
  const Vec3& maximum = surface.maximumCurvatureDirection[p];
  const Vec3 direction = Normalized(maximumIsAcross ? Cross(normal, maximum) : maximum);
  const double bend = across * surface.targetEdgeLength[p];
  if (!(bend > 0) || !(Norm2(direction) > 0))
  {
    return {};
  }
  // The rise of an edge over the surface goes with curvature times length squared.
  const double asked = along > 0 ? std::clamp(std::sqrt(across / along), 1.0, most) : most;
  const double trust = std::clamp((bend - 0.1) / 0.2, 0.0, 1.0);
  const double ratio = 1 + trust * (asked - 1);
  return std::sqrt(1 - 1 / (ratio * ratio)) * direction;
}

} // namespace

Stretch MeanStretch(const Stretch& a, const Stretch& b, const Stretch& c)
{
  const Vec3& longest =
    Norm2(a) >= Norm2(b) ? (Norm2(a) >= Norm2(c) ? a : c) : (Norm2(b) >= Norm2(c) ? b : c);
  Vec3 sum;
  for (const Vec3* s : { &a, &b, &c })
  {
    sum += Dot(*s, longest) < 0 ? -*s : *s;
  }
  return (1.0 / 3) * sum;
}

std::vector<Stretch> FindStretches(const TriangleComplex& surface, double most, Monitor& monitor)
{
  const auto count = static_cast<Id>(surface.points.size());
  const Lists star = TrianglesOfPoints(count, surface.triangles);
  std::vector<Tensor> tensors(surface.points.size());
  std::vector<Tensor> next(surface.points.size());
  const auto forPoints = [&](auto&& act)
  {
    monitor.For(count, grain,
                [&](Id begin, Id end)
                {
                  for (Id p = begin; p < end; ++p)
                  {
                    act(p, static_cast<std::size_t>(p));
                  }
                });
  };
  forPoints(
    [&](Id p, std::size_t v)
    {
      Vec3 normal;
      for (Id t : Row(star, p))
      {
        normal += AreaVector2(surface.points, surface.triangles[static_cast<std::size_t>(t)]);
      }
      tensors[v] = Square(StretchOf(surface, v, Normalized(normal), most));
    });
  for (int round = 0; round < rounds; ++round)
  {
    forPoints(
      [&](Id p, std::size_t v)
      {
        Tensor sum{};
        double corners = 0;
        for (Id t : Row(star, p))
        {
          for (Id q : surface.triangles[static_cast<std::size_t>(t)])
          {
            for (std::size_t i = 0; i < sum.size(); ++i)
            {
              sum[i] += tensors[static_cast<std::size_t>(q)][i];
            }
            corners += 1;
          }
        }
        for (double& value : sum)
        {
          value /= std::max(corners, 1.0);
        }
        next[v] = sum;
      });
    tensors.swap(next);
  }
  std::vector<Stretch> stretches(surface.points.size());
  forPoints([&](Id, std::size_t v) { stretches[v] = Root(tensors[v]); });
  return stretches;
}

} // namespace lamina
