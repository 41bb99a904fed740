// SPDX-License-Identifier: BSD-3-Clause
#include "WallDepth.h"

#include "../Search/TriangleTree.h"
#include "CellTets.h"
#include "PatchChoice.h"
#include "QuadraticHarmonic.h"

#include <algorithm>
#include <numeric>

namespace lamina
{
namespace
{

constexpr Id Grain = 1024;
/// A depth of less than this share of what the distances from both walls say: nothing of the other wall is
/// felt here.
constexpr double LeastShare = 0.05;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

enum Side : unsigned char
{
  OnInner = 1,
  OnOuter = 2
};

/// One a point: the walls it lies on.
std::vector<unsigned char> FindSides(const VolumeMesh& mesh, const std::vector<Triangle>& inner,
                                     const std::vector<Triangle>& outer)
{
  std::vector<unsigned char> sides(mesh.points.size(), 0);
  const auto mark = [&](const std::vector<Triangle>& triangles, Side side)
  {
    for (const Triangle& t : triangles)
    {
      for (Id p : t)
      {
        sides[Index(p)] |= side;
      }
    }
  };
  mark(inner, OnInner);
  mark(outer, OnOuter);
  return sides;
}

/// The cells of the materials in pieces, joined by points, that have both walls.
std::vector<Id> CellsWithBothWalls(const VolumeMesh& mesh, const std::vector<int>& materials,
                                   const std::vector<unsigned char>& sides)
{
  std::vector<Id> parent(mesh.points.size());
  std::iota(parent.begin(), parent.end(), Id{ 0 });
  const auto root = [&](Id p)
  {
    while (parent[Index(p)] != p)
    {
      p = parent[Index(p)] = parent[Index(parent[Index(p)])];
    }
    return p;
  };
  std::vector<Id> cells;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    if (std::find(materials.begin(), materials.end(), mesh.materials[Index(c)]) == materials.end())
    {
      continue;
    }
    cells.push_back(c);
    for (int k = 1; k < NodeCount(mesh.types[Index(c)]); ++k)
    {
      const Id a = root(mesh.Cell(c)[0]);
      const Id b = root(mesh.Cell(c)[k]);
      parent[Index(std::max(a, b))] = std::min(a, b);
    }
  }
  std::vector<unsigned char> seen(mesh.points.size(), 0);
  for (std::size_t p = 0; p < sides.size(); ++p)
  {
    seen[Index(root(static_cast<Id>(p)))] |= sides[p];
  }
  const auto lacksOne = [&](Id c) { return seen[Index(root(mesh.Cell(c)[0]))] != (OnInner | OnOuter); };
  cells.erase(std::remove_if(cells.begin(), cells.end(), lacksOne), cells.end());
  return cells;
}

Vec3 GradientIn(const VolumeMesh& mesh, Id cell, const std::vector<double>& values)
{
  const CellTets parts = TetsOfCell(mesh, cell);
  Vec3 sum;
  for (int t = 0; t < parts.count; ++t)
  {
    const auto& tet = parts.tets[static_cast<std::size_t>(t)];
    const TetShape shape = ShapeOf(mesh, tet);
    for (std::size_t k = 0; k < 4; ++k)
    {
      sum += shape.volume * values[Index(tet[k])] * shape.gradients[k];
    }
  }
  return Normalized(sum);
}

/// Depth and direction of each cell, left out where only one wall is felt.
void MeasureCells(const VolumeMesh& mesh, const std::vector<Id>& cells, const std::vector<double>& depth,
                  const std::vector<Triangle>& inner, const std::vector<Triangle>& outer,
                  WallDepthField& field, Monitor& monitor)
{
  const TriangleTree toInner(mesh.points, inner);
  const TriangleTree toOuter(mesh.points, outer);
  monitor.For(static_cast<Id>(cells.size()), Grain,
              [&](Id begin, Id end)
              {
                for (Id i = begin; i < end; ++i)
                {
                  const Id c = cells[Index(i)];
                  const int n = NodeCount(mesh.types[Index(c)]);
                  Vec3 middle;
                  double mean = 0;
                  for (int k = 0; k < n; ++k)
                  {
                    middle += mesh.points[Index(mesh.Cell(c)[k])] * (1.0 / n);
                    mean += depth[Index(mesh.Cell(c)[k])] / n;
                  }
                  const double a = std::sqrt(toInner.ClosestPoint(middle).distance2);
                  const double b = std::sqrt(toOuter.ClosestPoint(middle).distance2);
                  if (mean * (a + b) > LeastShare * a && (1 - mean) * (a + b) > LeastShare * b)
                  {
                    field.cells[Index(c)] = mean;
                    field.normals[Index(c)] = GradientIn(mesh, c, depth);
                  }
                }
              });
}

} // namespace

Result<WallDepthReport> ComputeWallDepth(const VolumeMesh& mesh, const MeshPatches& patches,
                                         const WallDepthOptions& options, WallDepthField& field,
                                         Monitor& monitor)
{
  const auto inner =
    ChoosePatches(mesh, patches, options.inner, PatchKind::Interface, options.materials, "inner wall");
  if (!inner)
  {
    return inner.GetError();
  }
  const auto outer =
    ChoosePatches(mesh, patches, options.outer, PatchKind::Wall, options.materials, "outer wall");
  if (!outer)
  {
    return outer.GetError();
  }
  const std::vector<unsigned char> sides = FindSides(mesh, *inner, *outer);
  const std::vector<Id> cells = CellsWithBothWalls(mesh, options.materials, sides);
  WallDepthReport report;
  std::vector<char> known(mesh.points.size(), 0);
  std::vector<double> depth(mesh.points.size(), 0.5);
  for (std::size_t p = 0; p < sides.size(); ++p)
  {
    known[p] = sides[p] != 0 ? 1 : 0;
    depth[p] = sides[p] == OnInner ? 0 : (sides[p] == OnOuter ? 1 : 0.5);
    report.contestedNodes += sides[p] == (OnInner | OnOuter) ? 1 : 0;
  }
  SubMonitor solving(monitor, 0, 0.4);
  const auto linear = SolveHarmonic(mesh, cells, known, depth, solving);
  if (!linear)
  {
    return linear.GetError();
  }
  std::vector<Triangle> walls = *inner;
  walls.insert(walls.end(), outer->begin(), outer->end());
  SubMonitor bending(monitor, 0.4, 0.8);
  const auto quadratic = SolveQuadraticHarmonic(mesh, cells, known, walls, depth, bending);
  if (!quadratic)
  {
    return quadratic.GetError();
  }
  report.iterations = linear->iterations + quadratic->iterations;
  // Obtuse cells can overshoot a little.
  std::transform(depth.begin(), depth.end(), depth.begin(), [](double d) { return std::clamp(d, 0.0, 1.0); });
  WallDepthField made;
  made.points.assign(mesh.points.size(), -1);
  made.cells.assign(mesh.types.size(), -1);
  made.normals.resize(mesh.types.size());
  MeasureCells(mesh, cells, depth, *inner, *outer, made, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    const bool isOurs = std::find(options.materials.begin(), options.materials.end(),
                                  mesh.materials[Index(c)]) != options.materials.end();
    const bool hasDepth = made.cells[Index(c)] >= 0;
    report.cells += hasDepth ? 1 : 0;
    report.oneSided += isOurs && !hasDepth ? 1 : 0;
    for (int k = 0; hasDepth && k < NodeCount(mesh.types[Index(c)]); ++k)
    {
      const std::size_t p = Index(mesh.Cell(c)[k]);
      made.points[p] = depth[p];
    }
  }
  field = std::move(made);
  monitor.Progress(1, "Depth found");
  return report;
}

} // namespace lamina
