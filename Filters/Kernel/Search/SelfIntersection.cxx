// SPDX-License-Identifier: BSD-3-Clause
#include "SelfIntersection.h"

#include "../Geometry/Predicates.h"

#include <algorithm>
#include <mutex>

namespace lamina
{
std::vector<std::array<Id, 2>> FindIntersections(const std::vector<Vec3>& points,
                                                 const std::vector<Triangle>& triangles, Monitor& monitor)
{
  const TriangleTree tree(points, triangles);
  std::vector<std::array<Id, 2>> pairs;
  std::mutex adding; // there are few, and their order is made below
  tree.ForPairs(0, monitor,
                [&](Id s, Id t)
                {
                  if (TrianglesIntersect(points, triangles[static_cast<std::size_t>(s)],
                                         triangles[static_cast<std::size_t>(t)]))
                  {
                    const std::lock_guard<std::mutex> lock(adding);
                    pairs.push_back({ { s, t } });
                  }
                });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::optional<Error> CheckEmbedded(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                                   const std::string& what, Monitor& monitor, std::vector<Id>* offending)
{
  const auto pairs = FindIntersections(points, triangles, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  if (pairs.empty())
  {
    return std::nullopt;
  }
  std::vector<Id> concerned;
  for (const auto& pair : pairs)
  {
    concerned.insert(concerned.end(), pair.begin(), pair.end());
  }
  std::sort(concerned.begin(), concerned.end());
  concerned.erase(std::unique(concerned.begin(), concerned.end()), concerned.end());
  std::vector<Vec3> places;
  for (Id t : concerned)
  {
    const Triangle& c = triangles[static_cast<std::size_t>(t)];
    places.push_back((1.0 / 3) *
                     (points[static_cast<std::size_t>(c[0])] + points[static_cast<std::size_t>(c[1])] +
                      points[static_cast<std::size_t>(c[2])]));
  }
  if (offending != nullptr)
  {
    *offending = std::move(concerned);
  }
  return InvalidInput(what + " intersects itself in " + std::to_string(pairs.size()) +
                        (pairs.size() == 1 ? " pair" : " pairs") + " of triangles" + DescribePlaces(places),
                      places);
}

} // namespace lamina
