// SPDX-License-Identifier: BSD-3-Clause
#include "RefinementDemand.h"

#include "../Mesh/Adjacency.h"

#include <numeric>

namespace lamina
{

namespace
{

/// Refinement leaves a tenth more triangles than equilateral ones of the wanted edges would be (measured on
/// phantoms and scans): edges near to the minimum follow targets that fall within a triangle.
constexpr double MoreThanIdeal = 1.1;
/// Measured, beside the surface handed in.
constexpr double BytesPerInputTriangle = 900;
constexpr double BytesPerTriangle = 600;
constexpr double BytesKept = 150;

} // namespace

std::vector<double> AsItIs(const TriangleComplex& surface)
{
  return std::vector<double>(surface.triangles.size(), 1.0);
}

std::vector<double> TrianglesWanted(const TriangleComplex& surface)
{
  std::vector<double> wanted = AsItIs(surface);
  if (surface.targetEdgeLength.size() != surface.points.size())
  {
    return wanted;
  }
  for (std::size_t t = 0; t < wanted.size(); ++t)
  {
    const Triangle& c = surface.triangles[t];
    double density = 0; // the mean over the corners
    for (Id p : c)
    {
      const double edge = surface.targetEdgeLength[static_cast<std::size_t>(p)];
      density += 1 / (3 * edge * edge);
    }
    wanted[t] = MoreThanIdeal * 0.5 * Norm(AreaVector2(surface.points, c)) / UnitArea * density;
  }
  return wanted;
}

MemoryDemand RefinementDemand(const TriangleComplex& surface)
{
  const std::vector<double> wanted = TrianglesWanted(surface);
  MemoryDemand demand;
  demand.cells = std::accumulate(wanted.begin(), wanted.end(), 0.0);
  demand.kept = BytesKept * demand.cells;
  demand.bytes = BytesPerInputTriangle * static_cast<double>(wanted.size()) + BytesPerTriangle * demand.cells;
  return demand;
}

} // namespace lamina
