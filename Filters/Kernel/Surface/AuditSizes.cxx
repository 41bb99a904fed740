// SPDX-License-Identifier: BSD-3-Clause
#include "AuditSizes.h"

#include <algorithm>

namespace lamina
{

SizeAudit AuditSizes(const TriangleComplex& surface)
{
  SizeAudit audit;
  if (surface.targetEdgeLength.size() != surface.points.size())
  {
    return audit;
  }
  std::vector<std::array<Id, 2>> edges;
  for (const Triangle& t : surface.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      edges.push_back({ { std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]) } });
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<double> ratios;
  for (const auto& e : edges)
  {
    const auto a = static_cast<std::size_t>(e[0]);
    const auto b = static_cast<std::size_t>(e[1]);
    const double target = 0.5 * (surface.targetEdgeLength[a] + surface.targetEdgeLength[b]);
    if (target > 0)
    {
      ratios.push_back(Norm(surface.points[b] - surface.points[a]) / target);
    }
  }
  if (ratios.empty())
  {
    return audit;
  }
  std::sort(ratios.begin(), ratios.end());
  const double shares[5] = { 0.01, 0.05, 0.5, 0.95, 0.99 };
  for (std::size_t k = 0; k < 5; ++k)
  {
    audit.percentiles[k] =
      ratios[static_cast<std::size_t>(shares[k] * static_cast<double>(ratios.size() - 1))];
  }
  audit.edges = static_cast<Id>(ratios.size());
  const auto good = std::count_if(ratios.begin(), ratios.end(), [](double r) { return r >= 0.5 && r <= 2; });
  audit.share = static_cast<double>(good) / static_cast<double>(ratios.size());
  return audit;
}

} // namespace lamina
