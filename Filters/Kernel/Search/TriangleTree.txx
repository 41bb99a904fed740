// SPDX-License-Identifier: BSD-3-Clause
// The queries that take a callable.
#pragma once

#include <algorithm>
#include <cmath>

namespace lamina
{

inline void Box::Add(const Vec3& p)
{
  for (int i = 0; i < 3; ++i)
  {
    this->low[i] = std::min(this->low[i], p[i]);
    this->high[i] = std::max(this->high[i], p[i]);
  }
}

inline void Box::Add(const Box& b)
{
  this->Add(b.low);
  this->Add(b.high);
}

inline void Box::Grow(double by)
{
  this->low -= { by, by, by };
  this->high += { by, by, by };
}

inline bool Box::Overlaps(const Box& b) const
{
  return this->low.x <= b.high.x && b.low.x <= this->high.x && this->low.y <= b.high.y &&
         b.low.y <= this->high.y && this->low.z <= b.high.z && b.low.z <= this->high.z;
}

inline double Box::Distance2(const Vec3& p) const
{
  double sum = 0;
  for (int i = 0; i < 3; ++i)
  {
    const double d = std::max({ this->low[i] - p[i], 0.0, p[i] - this->high[i] });
    sum += d * d;
  }
  return sum;
}

inline double Box::Distance2(const Box& b) const
{
  double sum = 0;
  for (int i = 0; i < 3; ++i)
  {
    const double d = std::max({ this->low[i] - b.high[i], 0.0, b.low[i] - this->high[i] });
    sum += d * d;
  }
  return sum;
}

namespace tree
{

/// Where origin + t / inverse enters the box, +inf if it misses it within [tMin, tMax]. A zero of the
/// direction has an infinite inverse; the NaN of 0 * inf (origin in the plane of a side) is taken as inside
/// the slab.
inline double Entry(const Box& box, const Vec3& origin, const Vec3& inverse, double tMin, double tMax)
{
  for (int i = 0; i < 3; ++i)
  {
    double from = (box.low[i] - origin[i]) * inverse[i];
    double to = (box.high[i] - origin[i]) * inverse[i];
    if (from > to)
    {
      std::swap(from, to);
    }
    // A ray along a side must not slip between two boxes by rounding. The order of the arguments drops NaNs.
    tMin = std::max(tMin, from * (from > 0 ? 1 - 1e-12 : 1 + 1e-12));
    tMax = std::min(tMax, to * (to > 0 ? 1 + 1e-12 : 1 - 1e-12));
  }
  return tMin <= tMax ? tMin : std::numeric_limits<double>::infinity();
}

/// Depth of the stacks of the queries: the build halves by the median below SplitByCost.
constexpr int SplitByCost = 48;
constexpr int StackSize = 128;

} // namespace tree

template<typename Accept>
TriangleTree::Hit TriangleTree::FirstHit(const Vec3& origin, const Vec3& direction, double tMin, double tMax,
                                         Accept&& accept) const
{
  Hit best;
  best.t = tMax;
  if (this->Nodes.empty())
  {
    return Hit{};
  }
  const Vec3 inverse{ 1 / direction.x, 1 / direction.y, 1 / direction.z };
  struct Step
  {
    std::int64_t node;
    double entry;
  };
  std::array<Step, tree::StackSize> stack;
  std::size_t top = 0;
  const auto step = [&](std::int64_t node)
  {
    return Step{ node, tree::Entry(this->Nodes[static_cast<std::size_t>(node)].box, origin, inverse, tMin,
                                   best.t) };
  };
  stack[top++] = step(0);
  while (top > 0)
  {
    const Step here = stack[--top];
    if (!(here.entry <= best.t))
    {
      continue;
    }
    const Node& node = this->Nodes[static_cast<std::size_t>(here.node)];
    for (std::int64_t i = node.first; i < node.first + node.count; ++i)
    {
      const Id id = this->Order[static_cast<std::size_t>(i)];
      const Triangle& c = this->Triangles[static_cast<std::size_t>(id)];
      const double t = RayTriangle(origin, direction, this->Points[static_cast<std::size_t>(c[0])],
                                   this->Points[static_cast<std::size_t>(c[1])],
                                   this->Points[static_cast<std::size_t>(c[2])]);
      const bool nearer = t > tMin && (t < best.t || (t == best.t && id < best.triangle));
      if (nearer && accept(id))
      {
        best = { id, t };
      }
    }
    if (node.HasChildren())
    {
      Step near = step(node.Left());
      Step far = step(node.Right());
      if (!(near.entry <= far.entry))
      {
        std::swap(near, far);
      }
      stack[top++] = far;
      stack[top++] = near;
    }
  }
  return best.triangle < 0 ? Hit{} : best;
}

template<typename Visit>
bool TriangleTree::FindNear(const Vec3& p, double limit2, Visit&& visit) const
{
  std::array<std::int64_t, tree::StackSize> stack;
  std::size_t top = 0;
  const auto distance2 = [&](std::int64_t node)
  { return this->Nodes[static_cast<std::size_t>(node)].box.Distance2(p); };
  if (!this->Nodes.empty() && distance2(0) <= limit2)
  {
    stack[top++] = 0;
  }
  while (top > 0)
  {
    const Node& node = this->Nodes[static_cast<std::size_t>(stack[--top])];
    for (std::int64_t i = node.first; i < node.first + node.count; ++i)
    {
      const Closest found = this->ClosestOnTriangle(this->Order[static_cast<std::size_t>(i)], p);
      if (found.distance2 <= limit2 && visit(found))
      {
        return true;
      }
    }
    if (node.HasChildren())
    {
      const double left = distance2(node.Left());
      const double right = distance2(node.Right());
      const bool leftFirst = left <= right;
      if (std::max(left, right) <= limit2)
      {
        stack[top++] = leftFirst ? node.Right() : node.Left();
      }
      if (std::min(left, right) <= limit2)
      {
        stack[top++] = leftFirst ? node.Left() : node.Right();
      }
    }
  }
  return false;
}

template<typename Visit>
void TriangleTree::ForOverlaps(const Box& box, Visit&& visit) const
{
  std::array<std::int64_t, tree::StackSize> stack;
  int top = 0;
  if (!this->Nodes.empty())
  {
    stack[static_cast<std::size_t>(top++)] = 0;
  }
  while (top > 0)
  {
    const Node& node = this->Nodes[static_cast<std::size_t>(stack[static_cast<std::size_t>(--top)])];
    if (!node.box.Overlaps(box))
    {
      continue;
    }
    for (std::int64_t i = node.first; i < node.first + node.count; ++i)
    {
      const Id id = this->Order[static_cast<std::size_t>(i)];
      Box own;
      for (Id corner : this->Triangles[static_cast<std::size_t>(id)])
      {
        own.Add(this->Points[static_cast<std::size_t>(corner)]);
      }
      if (own.Overlaps(box) && !visit(id))
      {
        return;
      }
    }
    if (node.HasChildren())
    {
      stack[static_cast<std::size_t>(top++)] = node.Right();
      stack[static_cast<std::size_t>(top++)] = node.Left();
    }
  }
}

template<typename Visit>
void TriangleTree::ForPairs(double growth, Monitor& monitor, const Visit& visit) const
{
  monitor.For(static_cast<Id>(this->Nodes.size()), 512,
              [&](Id begin, Id end)
              {
                for (Id node = begin; node < end; ++node)
                {
                  if (!this->Nodes[static_cast<std::size_t>(node)].HasChildren())
                  {
                    this->ForPairsOfLeaf(node, growth, visit);
                  }
                }
              });
}

/// The pairs of this leaf's triangles with one another and with those of later leaves: one walk down the tree
/// serves all of them.
template<typename Visit>
void TriangleTree::ForPairsOfLeaf(std::int64_t own, double growth, const Visit& visit) const
{
  const Node& leaf = this->Nodes[static_cast<std::size_t>(own)];
  std::array<Box, tree::LeafSize> ours;
  std::array<Box, tree::LeafSize> theirs;
  const std::size_t count = this->BoxesOfLeaf(leaf, ours);
  Box reach = leaf.box;
  reach.Grow(growth);
  for (std::size_t i = 0; i < count; ++i)
  {
    ours[i].Grow(growth);
  }
  std::array<std::int64_t, tree::StackSize> stack;
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0)
  {
    const std::int64_t other = stack[--top];
    const Node& node = this->Nodes[static_cast<std::size_t>(other)];
    if (!node.box.Overlaps(reach))
    {
      continue;
    }
    if (node.HasChildren())
    {
      stack[top++] = node.Right();
      stack[top++] = node.Left();
      continue;
    }
    const std::size_t others = other < own ? 0 : this->BoxesOfLeaf(node, theirs);
    for (std::size_t i = 0; i < count; ++i)
    {
      for (std::size_t j = other == own ? i + 1 : 0; j < others; ++j)
      {
        if (ours[i].Overlaps(theirs[j]))
        {
          const Id s = this->Order[static_cast<std::size_t>(leaf.first) + i];
          const Id t = this->Order[static_cast<std::size_t>(node.first) + j];
          visit(std::min(s, t), std::max(s, t));
        }
      }
    }
  }
}

} // namespace lamina
