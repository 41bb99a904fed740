// SPDX-License-Identifier: BSD-3-Clause
#include "RefinementResult.h"

#include "../Geometry/Quality.h"
#include "../Geometry/VisibleDirection.h"
#include "../Search/SelfIntersection.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

void RestoreWithoutIntersections(TriangleComplex& surface, const SheetGraph& sheets,
                                 const std::vector<double>& targets, Monitor& monitor)
{
  const std::vector<Vec3> start = surface.points;
  std::vector<char> frozen(surface.points.size(), 0);
  const Lists star = TrianglesOfPoints(static_cast<Id>(start.size()), surface.triangles);
  for (int round = 0; round < 8; ++round)
  {
    RestoreVolumes(surface, sheets, targets, frozen);
    const auto pairs = FindIntersections(surface.points, surface.triangles, monitor);
    if (pairs.empty())
    {
      return;
    }
    surface.points = start;
    for (const auto& pair : pairs)
    {
      for (Id t : pair)
      {
        for (Id p : surface.triangles[static_cast<std::size_t>(t)])
        {
          for (Id near : Row(star, p))
          {
            for (Id q : surface.triangles[static_cast<std::size_t>(near)])
            {
              frozen[static_cast<std::size_t>(q)] = 1;
            }
          }
        }
      }
    }
  }
  // Better a small error of volume, which the report tells, than an intersection.
}

namespace
{

/// Whether no direction into some material sees all its faces around p.
bool IsHidden(const TriangleComplex& surface, const Lists& star, Id p)
{
  constexpr double leastCosine = 0.4;
  std::vector<int> done{ 0 };
  std::vector<Vec3> normals;
  for (Id first : Row(star, p))
  {
    const MaterialPair& pair = surface.materials[static_cast<std::size_t>(first)];
    for (int material : { pair.first, pair.second })
    {
      if (std::find(done.begin(), done.end(), material) != done.end())
      {
        continue;
      }
      done.push_back(material);
      normals.clear();
      for (Id t : Row(star, p))
      {
        const auto v = static_cast<std::size_t>(t);
        const int side = SideOf(surface.materials[v], material);
        if (side != 0)
        {
          normals.push_back(side * Normalized(AreaVector2(surface.points, surface.triangles[v])));
        }
      }
      if (FindVisibleDirection(normals).leastCosine < leastCosine)
      {
        return true;
      }
    }
  }
  return false;
}

void FindHiddenNodes(const TriangleComplex& surface, RefineSurfaceReport& report, Monitor& monitor)
{
  const auto count = static_cast<Id>(surface.points.size());
  const Lists star = TrianglesOfPoints(count, surface.triangles);
  std::vector<char> hidden(surface.points.size(), 0);
  monitor.For(count, 4096,
              [&](Id begin, Id end)
              {
                for (Id p = begin; p < end; ++p)
                {
                  hidden[static_cast<std::size_t>(p)] = IsHidden(surface, star, p) ? 1 : 0;
                }
              });
  for (Id p = 0; p < count; ++p)
  {
    if (hidden[static_cast<std::size_t>(p)])
    {
      ++report.hiddenNodes;
      report.hiddenPoints.push_back(p);
      report.hiddenPlaces.push_back(surface.points[static_cast<std::size_t>(p)]);
    }
  }
}

} // namespace

void MeasureRefined(const TriangleComplex& surface, RefineSurfaceReport& report, Monitor& monitor)
{
  report.triangles = static_cast<Id>(surface.triangles.size());
  report.leastQuality = 1;
  Id inRange = 0;
  Id edges = 0;
  for (const Triangle& t : surface.triangles)
  {
    const auto at = [&](std::size_t k) { return surface.points[static_cast<std::size_t>(t[k % 3])]; };
    report.leastQuality = std::min(report.leastQuality, TriangleQuality(at(0), at(1), at(2)));
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double h = 0.5 * (surface.targetEdgeLength[static_cast<std::size_t>(t[k])] +
                              surface.targetEdgeLength[static_cast<std::size_t>(t[(k + 1) % 3])]);
      const double r = Norm(at(k) - at(k + 1)) / h;
      ++edges;
      inRange += r >= 0.5 && r <= 1.5 ? 1 : 0;
    }
  }
  report.edgesInRange = edges > 0 ? static_cast<double>(inRange) / static_cast<double>(edges) : 1;
  FindHiddenNodes(surface, report, monitor);
}

} // namespace lamina
