// SPDX-License-Identifier: BSD-3-Clause
#include "Adjacency.h"

#include <algorithm>

namespace lamina
{

Lists TrianglesOfPoints(Id pointCount, const std::vector<Triangle>& triangles)
{
  Lists lists;
  lists.offsets.assign(static_cast<std::size_t>(pointCount) + 1, 0);
  for (const Triangle& t : triangles)
  {
    for (Id p : t)
    {
      ++lists.offsets[static_cast<std::size_t>(p) + 1];
    }
  }
  for (std::size_t i = 1; i < lists.offsets.size(); ++i)
  {
    lists.offsets[i] += lists.offsets[i - 1];
  }
  lists.data.resize(3 * triangles.size());
  std::vector<Id> fill(lists.offsets.begin(), lists.offsets.end() - 1);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (Id p : triangles[i])
    {
      lists.data[static_cast<std::size_t>(fill[static_cast<std::size_t>(p)]++)] = static_cast<Id>(i);
    }
  }
  return lists;
}

EdgeTable MakeEdgeTable(const std::vector<Triangle>& triangles)
{
  struct Use
  {
    Id a;
    Id b;
    Id triangle;
  };
  std::vector<Use> uses;
  uses.reserve(3 * triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id p = triangles[i][static_cast<std::size_t>(k)];
      const Id q = triangles[i][static_cast<std::size_t>((k + 1) % 3)];
      uses.push_back({ std::min(p, q), std::max(p, q), static_cast<Id>(i) });
    }
  }
  std::sort(uses.begin(), uses.end(),
            [](const Use& u, const Use& v)
            { return u.a != v.a ? u.a < v.a : (u.b != v.b ? u.b < v.b : u.triangle < v.triangle); });
  EdgeTable table;
  std::size_t count = 0;
  for (std::size_t i = 0; i < uses.size(); ++i)
  {
    count += i == 0 || uses[i].a != uses[i - 1].a || uses[i].b != uses[i - 1].b ? 1 : 0;
  }
  table.edges.reserve(count);
  table.triangles.offsets.reserve(count + 1);
  table.triangles.data.reserve(uses.size());
  for (const Use& use : uses)
  {
    if (table.edges.empty() || table.edges.back().a != use.a || table.edges.back().b != use.b)
    {
      table.edges.push_back({ use.a, use.b });
      table.triangles.offsets.push_back(static_cast<Id>(table.triangles.data.size()));
    }
    table.triangles.data.push_back(use.triangle);
  }
  table.triangles.offsets.push_back(static_cast<Id>(table.triangles.data.size()));
  return table;
}

std::vector<int> MaterialsOf(const TriangleComplex& surface)
{
  int largest = 0;
  for (const MaterialPair& pair : surface.materials)
  {
    largest = std::max({ largest, pair.first, pair.second });
  }
  std::vector<char> present(static_cast<std::size_t>(largest) + 1, 0);
  for (const MaterialPair& pair : surface.materials)
  {
    present[static_cast<std::size_t>(pair.first)] = 1;
    present[static_cast<std::size_t>(pair.second)] = 1;
  }
  std::vector<int> found;
  for (int material = 1; material <= largest; ++material)
  {
    if (present[static_cast<std::size_t>(material)])
    {
      found.push_back(material);
    }
  }
  return found;
}

bool IsOpening(const TriangleComplex& surface, int patch)
{
  const auto p = static_cast<std::size_t>(patch);
  return patch > 0 && p < surface.patchNames.size() && surface.patchNames[p].rfind("opening", 0) == 0;
}

std::vector<double> MeanEdgesAtPoints(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
{
  std::vector<double> mean(points.size(), 0);
  std::vector<int> count(points.size(), 0);
  for (const Triangle& t : triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t a = static_cast<std::size_t>(t[k]);
      const std::size_t b = static_cast<std::size_t>(t[(k + 1) % 3]);
      const double length = Norm(points[b] - points[a]);
      for (std::size_t p : { a, b })
      {
        mean[p] += length;
        ++count[p];
      }
    }
  }
  for (std::size_t p = 0; p < mean.size(); ++p)
  {
    mean[p] = count[p] > 0 ? mean[p] / count[p] : 0;
  }
  return mean;
}

double MeanEdgeLength(const TriangleComplex& surface)
{
  double sum = 0;
  for (const Triangle& t : surface.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      sum += Norm(surface.points[static_cast<std::size_t>(t[(k + 1) % 3])] -
                  surface.points[static_cast<std::size_t>(t[k])]);
    }
  }
  return surface.triangles.empty() ? 0 : sum / (3.0 * static_cast<double>(surface.triangles.size()));
}

} // namespace lamina
