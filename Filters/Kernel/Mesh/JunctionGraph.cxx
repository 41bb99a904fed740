// SPDX-License-Identifier: BSD-3-Clause
#include "JunctionGraph.h"

#include <algorithm>

namespace lamina
{

bool IsFeatureEdge(const TriangleComplex& surface, const Id* begin, const Id* end)
{
  if (end - begin != 2)
  {
    return true;
  }
  const auto s = static_cast<std::size_t>(begin[0]);
  const auto t = static_cast<std::size_t>(begin[1]);
  return surface.materials[s] != surface.materials[t] || surface.Patch(begin[0]) != surface.Patch(begin[1]);
}

std::vector<char> FeatureEdges(const TriangleComplex& surface, const EdgeTable& table)
{
  std::vector<char> feature(table.edges.size());
  for (std::size_t e = 0; e < feature.size(); ++e)
  {
    const Id row = static_cast<Id>(e);
    feature[e] = IsFeatureEdge(surface, table.triangles.Begin(row), table.triangles.End(row)) ? 1 : 0;
  }
  return feature;
}

namespace
{

unsigned char CountMaterials(const TriangleComplex& surface, const Lists& star, Id point)
{
  std::vector<int> seen;
  for (Id t : Row(star, point))
  {
    const MaterialPair& pair = surface.materials[static_cast<std::size_t>(t)];
    for (int material : { pair.first, pair.second })
    {
      if (std::find(seen.begin(), seen.end(), material) == seen.end())
      {
        seen.push_back(material);
      }
    }
  }
  return static_cast<unsigned char>(std::min<std::size_t>(seen.size(), 255));
}

} // namespace

void ClassifyJunctions(TriangleComplex& surface)
{
  const std::size_t count = surface.points.size();
  const Lists star = TrianglesOfPoints(static_cast<Id>(count), surface.triangles);
  const EdgeTable table = MakeEdgeTable(surface.triangles);
  const std::vector<char> feature = FeatureEdges(surface, table);
  std::vector<int> features(count, 0);
  for (std::size_t e = 0; e < feature.size(); ++e)
  {
    if (feature[e])
    {
      ++features[static_cast<std::size_t>(table.edges[e].a)];
      ++features[static_cast<std::size_t>(table.edges[e].b)];
    }
  }
  surface.junctionOrder.resize(count);
  surface.junctionKind.resize(count);
  for (std::size_t p = 0; p < count; ++p)
  {
    surface.junctionOrder[p] = CountMaterials(surface, star, static_cast<Id>(p));
    unsigned char kind =
      features[p] == 0 ? JunctionSheet : (features[p] == 2 ? JunctionCurve : JunctionCorner);
    const ListRow row = Row(star, static_cast<Id>(p));
    if (std::any_of(row.begin(), row.end(), [&](Id t) { return surface.Patch(t) != 0; }))
    {
      kind = static_cast<unsigned char>(kind + JunctionInBorderPlane);
    }
    surface.junctionKind[p] = kind;
  }
}

} // namespace lamina
