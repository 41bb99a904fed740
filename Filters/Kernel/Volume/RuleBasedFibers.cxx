// SPDX-License-Identifier: BSD-3-Clause
#include "RuleBasedFibers.h"

#include "../Search/TriangleTree.h"
#include "PatchChoice.h"

#include <Eigen/Dense>

#include <algorithm>

namespace lamina
{
namespace
{

constexpr Id Grain = 1024;
constexpr double Degree = 3.14159265358979323846 / 180;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

bool Contains(const std::vector<int>& list, int value)
{
  return std::find(list.begin(), list.end(), value) != list.end();
}

Vec3 MiddleOf(const VolumeMesh& mesh, Id cell)
{
  const int n = NodeCount(mesh.types[Index(cell)]);
  Vec3 sum;
  for (int k = 0; k < n; ++k)
  {
    sum += mesh.points[Index(mesh.Cell(cell)[k])];
  }
  return sum * (1.0 / n);
}

/// The direction in which the cells of the materials extend farthest; it points to the larger z (or y, or x).
Vec3 LongAxis(const VolumeMesh& mesh, const std::vector<int>& materials)
{
  Vec3 mean;
  Id count = 0;
  const auto forCells = [&](const auto& visit)
  {
    for (Id c = 0; c < mesh.CellCount(); ++c)
    {
      if (Contains(materials, mesh.materials[Index(c)]))
      {
        visit(MiddleOf(mesh, c));
      }
    }
  };
  forCells(
    [&](const Vec3& p)
    {
      mean += p;
      ++count;
    });
  mean *= count > 0 ? 1.0 / static_cast<double>(count) : 0;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  forCells(
    [&](const Vec3& p)
    {
      const Eigen::Vector3d d(p.x - mean.x, p.y - mean.y, p.z - mean.z);
      spread += d * d.transpose();
    });
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Eigen::Vector3d v = solver.eigenvectors().col(2);
  const Vec3 axis{ v[0], v[1], v[2] };
  const double sign = std::abs(axis.z) > 1e-9 ? axis.z : (std::abs(axis.y) > 1e-9 ? axis.y : axis.x);
  return sign < 0 ? -axis : axis;
}

/// A unit vector orthogonal to `to`, as near to `v` as can be; zero if they are parallel.
Vec3 Orthogonal(const Vec3& v, const Vec3& to)
{
  const Vec3 rest = v - Dot(v, to) * to;
  return Norm(rest) > 1e-6 * Norm(v) ? Normalized(rest) : Vec3{};
}

} // namespace

Result<FiberReport> ComputeFibers(const VolumeMesh& mesh, const MeshPatches& patches,
                                  const FiberOptions& options, FiberField& field, Monitor& monitor)
{
  for (double angle : { options.helixEndo, options.helixEpi, options.transverse })
  {
    if (!(angle >= -90 && angle <= 90))
    {
      return InvalidOption("an angle is " + std::to_string(angle) + ", but must be from -90 to 90 degrees");
    }
  }
  const auto endo =
    ChoosePatches(mesh, patches, options.endocardium, PatchKind::Interface, options.materials, "endocardium");
  if (!endo)
  {
    return endo.GetError();
  }
  const auto epi =
    ChoosePatches(mesh, patches, options.epicardium, PatchKind::Wall, options.materials, "epicardium");
  if (!epi)
  {
    return epi.GetError();
  }
  const TriangleTree toEndo(mesh.points, *endo);
  const TriangleTree toEpi(mesh.points, *epi);
  FiberReport report;
  report.axis = Norm(options.axis) > 0 ? Normalized(options.axis) : LongAxis(mesh, options.materials);
  // Where the wall runs across the axis, any other direction stands in for it: always the same.
  const Vec3 spare = std::abs(report.axis.x) < 0.9 ? Vec3{ 1, 0, 0 } : Vec3{ 0, 1, 0 };
  FiberField made;
  made.fibers.resize(mesh.types.size());
  made.sheets.resize(mesh.types.size());
  made.depth.assign(mesh.types.size(), -1);
  std::vector<char> isUndecided(mesh.types.size(), 0);
  monitor.Progress(0, "Laying fibres");
  monitor.For(mesh.CellCount(), Grain,
              [&](Id begin, Id end)
              {
                for (Id c = begin; c < end; ++c)
                {
                  if (!Contains(options.materials, mesh.materials[Index(c)]))
                  {
                    continue;
                  }
                  const Vec3 p = MiddleOf(mesh, c);
                  const auto inside = toEndo.ClosestPoint(p);
                  const auto outside = toEpi.ClosestPoint(p);
                  const double a = std::sqrt(inside.distance2);
                  const double b = std::sqrt(outside.distance2);
                  const double depth = a + b > 0 ? a / (a + b) : 0;
                  const Vec3 across = Normalized(outside.point - inside.point);
                  Vec3 up = Orthogonal(report.axis, across);
                  if (Norm2(up) == 0)
                  {
                    isUndecided[Index(c)] = 1;
                    up = Orthogonal(spare, across);
                  }
                  const Vec3 around = Cross(up, across);
                  const double helix =
                    Degree * (options.helixEndo + depth * (options.helixEpi - options.helixEndo));
                  const double lift = Degree * options.transverse;
                  const Vec3 along = std::cos(helix) * around + std::sin(helix) * up;
                  made.fibers[Index(c)] = Normalized(std::cos(lift) * along + std::sin(lift) * across);
                  made.sheets[Index(c)] = Normalized(std::cos(lift) * across - std::sin(lift) * along);
                  made.depth[Index(c)] = depth;
                }
              });
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  report.cells = std::count_if(made.depth.begin(), made.depth.end(), [](double d) { return d >= 0; });
  report.undecided = std::count(isUndecided.begin(), isUndecided.end(), 1);
  field = std::move(made);
  monitor.Progress(1, "Fibres laid");
  return report;
}

} // namespace lamina
