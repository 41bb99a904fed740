// SPDX-License-Identifier: BSD-3-Clause
#include "Closedness.h"

#include <algorithm>
#include <tuple>

namespace lamina
{
namespace
{

constexpr Id Grain = 8192;
constexpr std::size_t MostPlaces = 100;

/// One use of an edge by the boundary of a material, filed under its lower end.
struct EdgeUse
{
  Id high;
  int material;
  bool forward;
};

bool operator<(const EdgeUse& a, const EdgeUse& b)
{
  return std::tie(a.material, a.high, a.forward) < std::tie(b.material, b.high, b.forward);
}

/// Uses of edges filed by lower end: those of point p are uses[start[p]] to uses[start[p + 1] - 1].
struct EdgeUses
{
  std::vector<std::size_t> start;
  std::vector<EdgeUse> uses;
};

template<typename Visit>
void ForEdgeUses(const TriangleComplex& surface, Visit&& visit)
{
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const MaterialPair pair = surface.materials[t];
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id a = surface.triangles[t][k];
      const Id b = surface.triangles[t][(k + 1) % 3];
      visit(a, b, pair.first);
      if (pair.second != 0)
      {
        visit(b, a, pair.second);
      }
    }
  }
}

EdgeUses FileEdgeUses(const TriangleComplex& surface)
{
  EdgeUses filed;
  filed.start.assign(surface.points.size() + 1, 0);
  ForEdgeUses(surface, [&](Id a, Id b, int) { ++filed.start[static_cast<std::size_t>(std::min(a, b)) + 1]; });
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    filed.start[p + 1] += filed.start[p];
  }
  filed.uses.resize(filed.start.back());
  std::vector<std::size_t> next(filed.start.begin(), filed.start.end() - 1);
  ForEdgeUses(
    surface,
    [&](Id a, Id b, int material) {
      filed.uses[next[static_cast<std::size_t>(std::min(a, b))]++] = { std::max(a, b), material, a < b };
    });
  return filed;
}

/// The unsound edges among the sorted uses of edges from point `low` up.
void CollectUnsound(Id low, const EdgeUse* begin, const EdgeUse* end, std::vector<OpenEdge>& unsound)
{
  while (begin != end)
  {
    OpenEdge edge{ begin->material, low, begin->high, 0, 0 };
    for (; begin != end && begin->material == edge.material && begin->high == edge.b; ++begin)
    {
      ++(begin->forward ? edge.forward : edge.backward);
    }
    if (edge.forward != 1 || edge.backward != 1)
    {
      unsound.push_back(edge);
    }
  }
}

Vec3 Centre(const TriangleComplex& surface, std::size_t triangle)
{
  Vec3 sum;
  for (Id corner : surface.triangles[triangle])
  {
    sum += surface.points[static_cast<std::size_t>(corner)];
  }
  return sum * (1.0 / 3);
}

std::optional<Error> CheckTriangle(const TriangleComplex& surface, std::size_t t)
{
  const Triangle& c = surface.triangles[t];
  const Id count = static_cast<Id>(surface.points.size());
  const std::string name = "triangle " + std::to_string(t);
  if (*std::min_element(c.begin(), c.end()) < 0 || *std::max_element(c.begin(), c.end()) >= count)
  {
    return InvalidInput(name + " names a point that is not there (there are " + std::to_string(count) + ")");
  }
  if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
  {
    return InvalidInput(name + " has a corner twice: clean the surface first", { Centre(surface, t) });
  }
  const MaterialPair pair = surface.materials[t];
  const bool ordered = pair.first > 0 && (pair.second == 0 || pair.first < pair.second);
  if (!ordered)
  {
    return InvalidInput(name + " has the materials (" + std::to_string(pair.first) + ", " +
                          std::to_string(pair.second) +
                          "): two ascending ids, or one and 0 for the background, are needed",
                        { Centre(surface, t) });
  }
  return std::nullopt;
}

} // namespace

std::optional<Error> CheckArrays(const TriangleComplex& surface)
{
  const std::size_t count = surface.triangles.size();
  if (surface.materials.size() != count || (!surface.patches.empty() && surface.patches.size() != count))
  {
    return InvalidInput("the surface has " + std::to_string(count) + " triangles but " +
                        std::to_string(surface.materials.size()) + " material pairs and " +
                        std::to_string(surface.patches.size()) + " patch ids");
  }
  if (!surface.missing.empty() && surface.missing.size() != count)
  {
    return InvalidInput("the surface has " + std::to_string(count) + " triangles but " +
                        std::to_string(surface.missing.size()) + " missing volumes");
  }
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    if (!IsFinite(surface.points[p]))
    {
      return InvalidInput("point " + std::to_string(p) + " of the surface is not a finite position");
    }
  }
  for (std::size_t t = 0; t < count; ++t)
  {
    if (auto error = CheckTriangle(surface, t))
    {
      return error;
    }
  }
  return std::nullopt;
}

std::vector<OpenEdge> FindOpenEdges(const TriangleComplex& surface, Monitor& monitor)
{
  EdgeUses filed = FileEdgeUses(surface);
  const Id count = static_cast<Id>(surface.points.size());
  const Id blocks = (count + Grain - 1) / Grain;
  std::vector<std::vector<OpenEdge>> found(static_cast<std::size_t>(blocks));
  monitor.For(blocks, 1,
              [&](Id begin, Id end)
              {
                for (Id p = begin * Grain; p < std::min(count, end * Grain); ++p)
                {
                  EdgeUse* first = filed.uses.data() + filed.start[static_cast<std::size_t>(p)];
                  EdgeUse* last = filed.uses.data() + filed.start[static_cast<std::size_t>(p) + 1];
                  std::sort(first, last);
                  CollectUnsound(p, first, last, found[static_cast<std::size_t>(p / Grain)]);
                }
              });
  std::vector<OpenEdge> edges;
  for (const auto& part : found)
  {
    edges.insert(edges.end(), part.begin(), part.end());
  }
  std::sort(edges.begin(), edges.end(),
            [](const OpenEdge& a, const OpenEdge& b)
            { return std::tie(a.material, a.a, a.b) < std::tie(b.material, b.a, b.b); });
  return edges;
}

std::optional<Error> CheckClosed(const TriangleComplex& surface, bool manifold, Monitor& monitor)
{
  if (auto error = CheckArrays(surface))
  {
    return error;
  }
  auto edges = FindOpenEdges(surface, monitor);
  const auto sound =
    std::stable_partition(edges.begin(), edges.end(), [](const OpenEdge& e) { return e.IsOpen(); });
  const bool isOpen = sound != edges.begin();
  if (isOpen)
  {
    edges.erase(sound, edges.end());
  }
  if (edges.empty() || (!isOpen && !manifold))
  {
    return std::nullopt;
  }
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < std::min(edges.size(), MostPlaces); ++i)
  {
    places.push_back(0.5 * (surface.points[static_cast<std::size_t>(edges[i].a)] +
                            surface.points[static_cast<std::size_t>(edges[i].b)]));
  }
  const std::string number = std::to_string(edges.size()) + (edges.size() == 1 ? " edge" : " edges");
  const std::string first =
    ", the first from point " + std::to_string(edges.front().a) + " to " + std::to_string(edges.front().b);
  const std::string material = "the boundary of material " + std::to_string(edges.front().material);
  return InvalidInput(isOpen ? material + " is open or turns its normals over (" + number + " in all" +
                                 first + "): close the surface"
                             : material + " meets itself (" + number +
                                 " with more than two triangles): part the sheets",
                      places);
}

} // namespace lamina
