// SPDX-License-Identifier: BSD-3-Clause
#include "SelfIntersection.h"

#include "../Geometry/Predicates.h"

#include <algorithm>

namespace lamina
{
namespace
{

constexpr Id Grain = 2048;

} // namespace

std::vector<std::array<Id, 2>> FindIntersections(const std::vector<Vec3>& points,
                                                 const std::vector<Triangle>& triangles, Monitor& monitor)
{
  const TriangleTree tree(points, triangles);
  const Id count = static_cast<Id>(triangles.size());
  // Pieces of the range may be cut anyhow: what triangle i finds is kept under i's block, which only one
  // thread writes.
  const Id blocks = (count + Grain - 1) / Grain;
  std::vector<std::vector<std::array<Id, 2>>> found(static_cast<std::size_t>(blocks));
  monitor.For(blocks, 1,
              [&](Id begin, Id end)
              {
                for (Id i = begin * Grain; i < std::min(count, end * Grain); ++i)
                {
                  const Triangle& own = triangles[static_cast<std::size_t>(i)];
                  Box box;
                  for (Id corner : own)
                  {
                    box.Add(points[static_cast<std::size_t>(corner)]);
                  }
                  tree.ForOverlaps(
                    box,
                    [&](Id j)
                    {
                      if (i < j && TrianglesIntersect(points, own, triangles[static_cast<std::size_t>(j)]))
                      {
                        found[static_cast<std::size_t>(i / Grain)].push_back({ { i, j } });
                      }
                      return true;
                    });
                }
              });
  std::vector<std::array<Id, 2>> pairs;
  for (const auto& part : found)
  {
    pairs.insert(pairs.end(), part.begin(), part.end());
  }
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
