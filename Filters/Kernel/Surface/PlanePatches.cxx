// SPDX-License-Identifier: BSD-3-Clause
#include "PlanePatches.h"

#include "../Mesh/Adjacency.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace lamina
{

Id NamePlanePatches(const std::vector<int>& planeOfTriangle, TriangleComplex& surface)
{
  if (std::all_of(planeOfTriangle.begin(), planeOfTriangle.end(), [](int p) { return p == 0; }))
  {
    return 0;
  }
  const std::size_t count = surface.triangles.size();
  std::vector<std::size_t> root(count);
  std::iota(root.begin(), root.end(), std::size_t{ 0 });
  const auto find = [&](std::size_t t)
  {
    while (root[t] != t)
    {
      t = root[t] = root[root[t]];
    }
    return t;
  };
  const EdgeTable table = MakeEdgeTable(surface.triangles);
  for (std::size_t e = 0; e < table.edges.size(); ++e)
  {
    for (Id s : Row(table.triangles, static_cast<Id>(e)))
    {
      for (Id t : Row(table.triangles, static_cast<Id>(e)))
      {
        const auto a = static_cast<std::size_t>(s);
        const auto b = static_cast<std::size_t>(t);
        if (a < b && planeOfTriangle[a] < 0 && planeOfTriangle[a] == planeOfTriangle[b] &&
            surface.materials[a] == surface.materials[b])
        {
          const std::size_t ra = find(a);
          const std::size_t rb = find(b);
          root[std::max(ra, rb)] = std::min(ra, rb);
        }
      }
    }
  }
  // Openings are numbered in the order of their first triangle, then come the borders.
  surface.patches.assign(count, 0);
  surface.patchNames = { "wall" };
  std::map<std::size_t, int> openings;
  for (std::size_t t = 0; t < count; ++t)
  {
    if (planeOfTriangle[t] < 0)
    {
      const auto entry = openings.insert({ find(t), static_cast<int>(surface.patchNames.size()) });
      if (entry.second)
      {
        surface.patchNames.push_back("opening_" + std::to_string(openings.size()));
      }
      surface.patches[t] = entry.first->second;
    }
  }
  std::map<int, int> borders;
  for (std::size_t t = 0; t < count; ++t)
  {
    if (planeOfTriangle[t] > 0)
    {
      const int plane = planeOfTriangle[t];
      const auto entry = borders.insert({ plane, static_cast<int>(surface.patchNames.size()) });
      if (entry.second)
      {
        surface.patchNames.push_back("border_" + std::to_string(plane));
      }
      surface.patches[t] = entry.first->second;
    }
  }
  return static_cast<Id>(openings.size());
}

} // namespace lamina
