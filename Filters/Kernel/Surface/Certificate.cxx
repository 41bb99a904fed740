// SPDX-License-Identifier: BSD-3-Clause
#include "Certificate.h"

#include "../Mesh/EdgeAngles.h"
#include "../Search/SelfIntersection.h"
#include "../Search/SheetGaps.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

namespace
{

constexpr double farthestLook = 1; ///< mean edge lengths
constexpr double degree = 3.141592653589793 / 180;

double ClearanceOf(const TriangleComplex& surface, const EdgeTable& table, Monitor& monitor)
{
  const Lists star = TrianglesOfPoints(static_cast<Id>(surface.points.size()), surface.triangles);
  // The wider the search the longer it takes, and mostly sheets stand close: it widens until some are found.
  double least = 0;
  for (const double reach : { 0.3, farthestLook })
  {
    const double cutoff = reach * MeanEdgeLength(surface);
    const std::vector<double> gaps =
      MeasureGaps(surface.points, surface.triangles, table, star, cutoff, monitor).facing;
    least = gaps.empty() ? 0 : *std::min_element(gaps.begin(), gaps.end());
    if (least < cutoff || monitor.Cancelled())
    {
      break;
    }
  }
  return least;
}

double AngleOf(const TriangleComplex& surface, const EdgeTable& table)
{
  double greatest = -1; // cosine
  for (std::size_t e = 0; e < table.edges.size(); ++e)
  {
    const ListRow row = Row(table.triangles, static_cast<Id>(e));
    for (const Id* s = row.first; s != row.last; ++s)
    {
      for (const Id* t = s + 1; t != row.last; ++t)
      {
        greatest =
          std::max(greatest, CosineAtEdge(surface.points, surface.triangles, table.edges[e], *s, *t));
      }
    }
  }
  return std::acos(std::min(1.0, greatest)) / degree;
}

} // namespace

double LeastClearance(const TriangleComplex& surface, Monitor& monitor)
{
  return ClearanceOf(surface, MakeEdgeTable(surface.triangles), monitor);
}

double LeastAngle(const TriangleComplex& surface)
{
  return AngleOf(surface, MakeEdgeTable(surface.triangles));
}

SurfaceCertificate Certify(const TriangleComplex& surface, Monitor& monitor)
{
  SurfaceCertificate certificate;
  certificate.intersectingPairs =
    static_cast<Id>(FindIntersections(surface.points, surface.triangles, monitor).size());
  const EdgeTable table = MakeEdgeTable(surface.triangles);
  certificate.leastClearance = certificate.intersectingPairs > 0 ? 0 : ClearanceOf(surface, table, monitor);
  certificate.leastAngle = AngleOf(surface, table);
  return certificate;
}

} // namespace lamina
