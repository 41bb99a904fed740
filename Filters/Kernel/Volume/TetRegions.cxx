// SPDX-License-Identifier: BSD-3-Clause
#include "TetRegions.h"

#include "../Mesh/TetFaces.h"
#include "../Search/TriangleTree.h"

#include <algorithm>
#include <numeric>

namespace lamina
{
namespace
{

constexpr int Unknown = -1;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

/// The least point of each connected piece, for every point.
std::vector<Id> FindPieces(const TriangleComplex& surface)
{
  std::vector<Id> parent(surface.points.size());
  std::iota(parent.begin(), parent.end(), Id{ 0 });
  const auto root = [&](Id p)
  {
    while (parent[Index(p)] != p)
    {
      p = parent[Index(p)] = parent[Index(parent[Index(p)])];
    }
    return p;
  };
  for (const Triangle& t : surface.triangles)
  {
    for (Id p : { t[1], t[2] })
    {
      const Id a = root(t[0]);
      const Id b = root(p);
      parent[Index(std::max(a, b))] = std::min(a, b);
    }
  }
  for (Id p = 0; p < static_cast<Id>(parent.size()); ++p)
  {
    parent[Index(p)] = root(p);
  }
  return parent;
}

/// The way from the triangle's middle along its normal to the next triangle; no triangle in the way: t of
/// infinity.
struct Sight
{
  Vec3 from;
  Vec3 direction;
  double t = 0;
};

Sight Look(const TriangleComplex& surface, const TriangleTree& tree, Id triangle)
{
  const Triangle& c = surface.triangles[Index(triangle)];
  const Vec3& a = surface.points[Index(c[0])];
  const Vec3& b = surface.points[Index(c[1])];
  const Vec3& d = surface.points[Index(c[2])];
  Sight sight;
  sight.from = (a + b + d) * (1.0 / 3);
  sight.direction = Normalized(Cross(b - a, d - a));
  sight.t = tree
              .FirstHit(sight.from, sight.direction, 0, std::numeric_limits<double>::infinity(),
                        [&](Id id) { return id != triangle; })
              .t;
  return sight;
}

/// Facets as walls between tets, and what they say of the material on either side.
class Walls
{
public:
  Walls(const TriangleComplex& surface, Id pointCount)
    : Surface(surface)
    , Table(surface.triangles, pointCount)
    , Seen(2 * surface.triangles.size(), 0)
  {
  }
  Id Find(const Triangle& face) const { return this->Table.Find(face); }
  /// The material of the tet behind `face` (counter-clockwise seen from outside the tet), which is facet f.
  int Behind(Id f, const Triangle& face)
  {
    const bool isFirst = TurnAlike(this->Surface.triangles[Index(f)], face);
    ++this->Seen[2 * Index(f) + (isFirst ? 0 : 1)];
    return isFirst ? this->Surface.materials[Index(f)].first : this->Surface.materials[Index(f)].second;
  }
  /// The facets without exactly one tet on each side that is a material.
  std::vector<Vec3> FindLost() const
  {
    std::vector<Vec3> places;
    for (std::size_t f = 0; f < this->Surface.triangles.size(); ++f)
    {
      const bool hasSecond = this->Surface.materials[f].second != 0;
      if (this->Seen[2 * f] != 1 || (hasSecond && this->Seen[2 * f + 1] != 1))
      {
        places.push_back(this->Surface.points[Index(this->Surface.triangles[f][0])]);
      }
    }
    return places;
  }

private:
  const TriangleComplex& Surface;
  FaceTable Table;
  std::vector<int> Seen;
};

void DropBackground(TetSet& set)
{
  std::size_t to = 0;
  for (std::size_t from = 0; from < set.tets.size(); ++from)
  {
    if (set.groups[from] > 0)
    {
      set.tets[to] = set.tets[from];
      set.groups[to] = set.groups[from];
      ++to;
    }
  }
  set.tets.resize(to);
  set.groups.resize(to);
}

/// Gives the tets at walls their material and notes which of their faces are walls; the tets are queued.
std::optional<Error> SeedAtWalls(TetSet& set, Walls& walls, std::vector<char>& isWall, std::vector<Id>& queue)
{
  for (Id t = 0; t < static_cast<Id>(set.tets.size()); ++t)
  {
    int& own = set.groups[Index(t)];
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Triangle face = TetFace(set.tets[Index(t)], k);
      const Id wall = walls.Find(face);
      if (wall < 0)
      {
        continue;
      }
      isWall[4 * Index(t) + k] = 1;
      const int material = walls.Behind(wall, face);
      if (own != Unknown && own != material)
      {
        return Unreachable("the triangles round a tetrahedron disagree on its material",
                           { set.points[Index(face[0])] });
      }
      if (own == Unknown)
      {
        queue.push_back(t);
        own = material;
      }
    }
  }
  return std::nullopt;
}

/// Carries the materials from the queued tets to all that no wall parts from them.
std::optional<Error> Spread(TetSet& set, const std::vector<std::array<Id, 4>>& neighbours,
                            const std::vector<char>& isWall, std::vector<Id>& queue)
{
  while (!queue.empty())
  {
    const Id t = queue.back();
    queue.pop_back();
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Id other = neighbours[Index(t)][k];
      if (other < 0 || isWall[4 * Index(t) + k] != 0)
      {
        continue;
      }
      if (set.groups[Index(other)] == Unknown)
      {
        set.groups[Index(other)] = set.groups[Index(t)];
        queue.push_back(other);
      }
      else if (set.groups[Index(other)] != set.groups[Index(t)])
      {
        return InvalidInput(
          "two materials meet without a triangle between them: the pieces of the surface do not "
          "fit into each other",
          { set.points[Index(set.tets[Index(t)][0])] });
      }
    }
  }
  return std::nullopt;
}

} // namespace

std::vector<Vec3> FindHoles(const TriangleComplex& surface)
{
  const auto pieces = FindPieces(surface);
  const TriangleTree tree(surface.points, surface.triangles);
  constexpr int enough = 16; // looks from a piece; the longest way is taken, clear of rounding
  std::vector<int> looks(surface.points.size(), 0);
  std::vector<Sight> best(surface.points.size());
  for (Id t = 0; t < static_cast<Id>(surface.triangles.size()); ++t)
  {
    const std::size_t piece = Index(pieces[Index(surface.triangles[Index(t)][0])]);
    if (surface.materials[Index(t)].second != 0 || looks[piece] >= enough)
    {
      continue;
    }
    ++looks[piece];
    const Sight sight = Look(surface, tree, t);
    if (!std::isfinite(sight.t))
    {
      looks[piece] = enough; // the piece borders on the outside, at least here
      best[piece].t = 0;
    }
    else if (sight.t > best[piece].t)
    {
      best[piece] = sight;
    }
  }
  std::vector<Vec3> holes;
  for (const Sight& sight : best)
  {
    if (sight.t > 0)
    {
      holes.push_back(sight.from + 0.5 * sight.t * sight.direction);
    }
  }
  return holes;
}

std::optional<Error> AssignRegions(const TriangleComplex& surface, TetSet& set, Monitor& monitor)
{
  const Id pointCount = static_cast<Id>(set.points.size());
  const auto neighbours = FindTetNeighbours(set.tets, pointCount, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  Walls walls(surface, pointCount);
  set.groups.assign(set.tets.size(), Unknown);
  std::vector<char> isWall(4 * set.tets.size(), 0);
  std::vector<Id> queue;
  if (auto error = SeedAtWalls(set, walls, isWall, queue))
  {
    return error;
  }
  const auto lost = walls.FindLost();
  if (!lost.empty())
  {
    return Unreachable(std::to_string(lost.size()) +
                         " triangles of the surface did not become faces of tetrahedra" +
                         DescribePlaces(lost),
                       lost);
  }
  if (auto error = Spread(set, neighbours, isWall, queue))
  {
    return error;
  }
  DropBackground(set);
  return std::nullopt;
}

} // namespace lamina
