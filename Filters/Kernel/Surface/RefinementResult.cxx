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

void MeasureRefined(const TriangleComplex& surface, const std::vector<Stretch>& stretches,
                    RefineSurfaceReport& report, Monitor& monitor)
{
  constexpr double good = 0.4;
  report.triangles = static_cast<Id>(surface.triangles.size());
  report.leastQuality = 1;
  Id inRange = 0;
  Id fair = 0;
  for (const Triangle& t : surface.triangles)
  {
    const auto index = [&](std::size_t k) { return static_cast<std::size_t>(t[k % 3]); };
    const auto stretch = [&](std::size_t k) { return stretches.empty() ? Stretch{} : stretches[index(k)]; };
    const Stretch mean = MeanStretch(stretch(0), stretch(1), stretch(2));
    const Vec3& a = surface.points[index(0)];
    const double quality = TriangleQuality({}, Unstretched(surface.points[index(1)] - a, mean),
                                           Unstretched(surface.points[index(2)] - a, mean));
    report.leastQuality = std::min(report.leastQuality, quality);
    fair += quality >= good ? 1 : 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double h = 0.5 * (surface.targetEdgeLength[index(k)] + surface.targetEdgeLength[index(k + 1)]);
      const Vec3 edge = surface.points[index(k)] - surface.points[index(k + 1)];
      const double r = std::sqrt(StretchedLength2(edge, stretch(k), stretch(k + 1))) / h;
      inRange += r >= 0.5 && r <= 1.5 ? 1 : 0;
    }
  }
  const auto share = [&](Id count, Id of)
  { return of > 0 ? static_cast<double>(count) / static_cast<double>(of) : 1; };
  report.edgesInRange = share(inRange, 3 * report.triangles);
  report.goodTriangles = share(fair, report.triangles);
  FindHiddenNodes(surface, report, monitor);
}

} // namespace lamina
