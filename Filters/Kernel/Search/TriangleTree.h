// SPDX-License-Identifier: BSD-3-Clause
// The one spatial tree: a bounding volume hierarchy over triangles.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Types.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace lamina
{

namespace tree
{

constexpr std::int64_t LeafSize = 4; ///< triangles at most

} // namespace tree

struct Box
{
  Vec3 low{ std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
            std::numeric_limits<double>::infinity() };
  Vec3 high{ -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
             -std::numeric_limits<double>::infinity() };

  void Add(const Vec3& p);
  void Add(const Box& b);
  void Grow(double by);
  bool Overlaps(const Box& b) const;
  double Distance2(const Vec3& p) const; ///< squared distance to p, 0 inside
  double Distance2(const Box& b) const;  ///< to another box, 0 where they overlap
};

/// A static bounding volume hierarchy over the triangles given at construction. Queries are const and
/// thread-safe. Points and triangles are referred to, not copied: they must outlive the tree (see Refit for
/// moved points).
class TriangleTree
{
public:
  TriangleTree(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);
  /// Only the given triangles enter the tree; ids in answers are those of `triangles`.
  TriangleTree(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
               std::vector<Id> subset);

  /// Recompute the boxes after points moved.
  void Refit();

  struct Closest
  {
    Id triangle = -1;
    Vec3 point;
    double distance2 = std::numeric_limits<double>::infinity();
    std::array<double, 3> weights{ { 0, 0, 0 } }; ///< barycentric coordinates in the triangle
  };
  /// The closest point of the surface within sqrt(limit2) of p; triangle -1 if there is none. Ties go to the
  /// lower id.
  Closest ClosestPoint(const Vec3& p, double limit2 = std::numeric_limits<double>::infinity()) const;

  /// Calls visit(place) for places of triangles within sqrt(limit2) of p, the nearest boxes first, until it
  /// returns true; returns whether it did.
  template<typename Visit>
  bool FindNear(const Vec3& p, double limit2, Visit&& visit) const;
  /// The closest point of one triangle.
  Closest ClosestOnTriangle(Id triangle, const Vec3& p) const;

  struct Hit
  {
    Id triangle = -1;
    double t = std::numeric_limits<double>::infinity(); ///< in lengths of `direction`
  };
  /// First hit of origin + t * direction with t in (tMin, tMax) among triangles that `accept(id)` allows.
  template<typename Accept>
  Hit FirstHit(const Vec3& origin, const Vec3& direction, double tMin, double tMax, Accept&& accept) const;

  /// Calls visit(id) for every triangle whose box overlaps `box`; visit returns false to stop.
  template<typename Visit>
  void ForOverlaps(const Box& box, Visit&& visit) const;

  /// Calls visit(s, t), s < t, once for every two triangles whose boxes come within `growth` of each other
  /// along each axis, from all threads of the monitor.
  template<typename Visit>
  void ForPairs(double growth, Monitor& monitor, const Visit& visit) const;

private:
  struct Node
  {
    Box box;
    std::int64_t first =
      0; ///< leaves: where their range in Order starts; else the left child, the right is next
    std::int64_t count = 0; ///< of triangles; 0 if there are children

    bool HasChildren() const { return this->count == 0; }
    std::int64_t Left() const { return this->first; }
    std::int64_t Right() const { return this->first + 1; }
  };
  void Build();
  /// The boxes of a leaf's triangles; returns how many there are.
  std::size_t BoxesOfLeaf(const Node& leaf, std::array<Box, tree::LeafSize>& boxes) const;
  template<typename Visit>
  void ForPairsOfLeaf(std::int64_t own, double growth, const Visit& visit) const;

  const std::vector<Vec3>& Points;
  const std::vector<Triangle>& Triangles;
  std::vector<Id> Order;
  std::vector<Node> Nodes;
};

/// Squared distance from p to triangle (a, b, c), its closest point and barycentric weights.
double PointTriangleDistance2(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, Vec3& closest,
                              std::array<double, 3>& weights);

/// Moeller-Trumbore: parameter t of the hit of origin + t * direction with triangle (a, b, c), edges
/// included, else NaN.
double RayTriangle(const Vec3& origin, const Vec3& direction, const Vec3& a, const Vec3& b, const Vec3& c);

} // namespace lamina

#include "TriangleTree.txx"
