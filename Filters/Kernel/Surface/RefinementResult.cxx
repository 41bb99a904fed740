// SPDX-License-Identifier: BSD-3-Clause
#include "RefinementResult.h"

#include "../Geometry/Quality.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

void MeasureRefined(const TriangleComplex& surface, const std::vector<Stretch>& stretches,
                    RefineSurfaceReport& report)
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
}

} // namespace lamina
