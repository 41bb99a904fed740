// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleTree.h"

#include <numeric>

namespace lamina
{
namespace
{

constexpr int BinCount = 16;

double HalfArea(const Box& box)
{
  const Vec3 e = box.high - box.low;
  return e.x < 0 ? 0 : e.x * e.y + e.y * e.z + e.z * e.x;
}

/// Boxes in an order that is being made: only their numbers move.
struct Boxes
{
  std::vector<Box> all;
  std::vector<Id> order;

  const Box& At(std::int64_t i) const
  {
    return this->all[static_cast<std::size_t>(this->order[static_cast<std::size_t>(i)])];
  }
  double Centre(Id box, int axis) const
  {
    const Box& own = this->all[static_cast<std::size_t>(box)];
    return 0.5 * (own.low[axis] + own.high[axis]);
  }
};

struct Bin
{
  Box box;
  std::int64_t count = 0;
};

int BinOf(double centre, const Box& centres, int axis)
{
  const double extent = centres.high[axis] - centres.low[axis];
  const int bin = static_cast<int>(BinCount * ((centre - centres.low[axis]) / extent));
  return std::clamp(bin, 0, BinCount - 1);
}

/// The last bin of the left part at the least cost (surface area times number on either side); -1 if nothing
/// parts.
int CheapestSplit(const std::array<Bin, BinCount>& bins)
{
  std::array<double, BinCount> rightCost{};
  Bin sum;
  for (std::size_t b = BinCount - 1; b > 0; --b)
  {
    sum.box.Add(bins[b].box);
    sum.count += bins[b].count;
    rightCost[b - 1] = HalfArea(sum.box) * static_cast<double>(sum.count);
  }
  const std::int64_t all = sum.count + bins[0].count;
  sum = Bin{};
  int best = -1;
  double bestCost = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b + 1 < BinCount; ++b)
  {
    sum.box.Add(bins[b].box);
    sum.count += bins[b].count;
    const double cost = HalfArea(sum.box) * static_cast<double>(sum.count) + rightCost[b];
    if (sum.count > 0 && sum.count < all && cost < bestCost)
    {
      bestCost = cost;
      best = static_cast<int>(b);
    }
  }
  return best;
}

int LongestAxis(const Box& box)
{
  const Vec3 e = box.high - box.low;
  return e.x >= e.y && e.x >= e.z ? 0 : (e.y >= e.z ? 1 : 2);
}

/// Parts [begin, end) in two, neither empty, and returns where the second starts. Deep down the tree by the
/// median, so that no input makes it deeper than the stacks of the queries.
std::int64_t Part(Boxes& boxes, std::int64_t begin, std::int64_t end, int depth)
{
  Box centres;
  for (std::int64_t i = begin; i < end; ++i)
  {
    centres.Add(0.5 * (boxes.At(i).low + boxes.At(i).high));
  }
  const int axis = LongestAxis(centres);
  const auto first = boxes.order.begin();
  if (depth < tree::SplitByCost && centres.high[axis] > centres.low[axis])
  {
    const auto binOf = [&](Id box) { return BinOf(boxes.Centre(box, axis), centres, axis); };
    std::array<Bin, BinCount> bins;
    for (std::int64_t i = begin; i < end; ++i)
    {
      Bin& bin = bins[static_cast<std::size_t>(binOf(first[i]))];
      bin.box.Add(boxes.At(i));
      ++bin.count;
    }
    const int last = CheapestSplit(bins);
    if (last >= 0)
    {
      return std::stable_partition(first + begin, first + end, [&](Id box) { return binOf(box) <= last; }) -
             first;
    }
  }
  const std::int64_t middle = begin + (end - begin) / 2;
  std::nth_element(first + begin, first + middle, first + end,
                   [&](Id a, Id b)
                   {
                     const double x = boxes.Centre(a, axis);
                     const double y = boxes.Centre(b, axis);
                     return x != y ? x < y : a < b;
                   });
  return middle;
}

std::vector<Id> AllOf(const std::vector<Triangle>& triangles)
{
  std::vector<Id> all(triangles.size());
  std::iota(all.begin(), all.end(), Id{ 0 });
  return all;
}

Box BoxOf(const std::vector<Vec3>& points, const Triangle& triangle)
{
  Box box;
  for (Id corner : triangle)
  {
    box.Add(points[static_cast<std::size_t>(corner)]);
  }
  return box;
}

} // namespace

TriangleTree::TriangleTree(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
  : TriangleTree(points, triangles, AllOf(triangles))
{
}

TriangleTree::TriangleTree(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                           std::vector<Id> subset)
  : Points(points)
  , Triangles(triangles)
  , Order(std::move(subset))
{
  this->Build();
}

void TriangleTree::Build()
{
  if (this->Order.empty())
  {
    return;
  }
  Boxes boxes;
  boxes.all.reserve(this->Order.size());
  boxes.order.reserve(this->Order.size());
  for (Id id : this->Order)
  {
    boxes.order.push_back(static_cast<Id>(boxes.all.size()));
    boxes.all.push_back(BoxOf(this->Points, this->Triangles[static_cast<std::size_t>(id)]));
  }
  struct Task
  {
    std::int64_t node;
    int depth;
  };
  const auto leaf = [](std::int64_t begin, std::int64_t end) { return Node{ {}, begin, end - begin }; };
  this->Nodes.reserve(boxes.all.size());
  this->Nodes.push_back(leaf(0, static_cast<std::int64_t>(boxes.all.size())));
  std::vector<Task> tasks{ { 0, 0 } };
  while (!tasks.empty())
  {
    const Task task = tasks.back();
    tasks.pop_back();
    Node& node = this->Nodes[static_cast<std::size_t>(task.node)];
    if (node.count <= tree::LeafSize)
    {
      continue;
    }
    const std::int64_t begin = node.first;
    const std::int64_t end = begin + node.count;
    const std::int64_t middle = Part(boxes, begin, end, task.depth);
    node.first = static_cast<std::int64_t>(this->Nodes.size());
    node.count = 0;
    tasks.push_back({ node.Right(), task.depth + 1 });
    tasks.push_back({ node.Left(), task.depth + 1 });
    this->Nodes.push_back(leaf(begin, middle));
    this->Nodes.push_back(leaf(middle, end));
  }
  boxes.all = {};
  const auto ordered = [&](Id i) { return this->Order[static_cast<std::size_t>(i)]; };
  std::transform(boxes.order.begin(), boxes.order.end(), boxes.order.begin(), ordered);
  this->Order = std::move(boxes.order);
  this->Refit();
}

void TriangleTree::Refit()
{
  // Children stand behind their parents.
  for (auto node = this->Nodes.rbegin(); node != this->Nodes.rend(); ++node)
  {
    node->box = Box{};
    for (std::int64_t i = node->first; i < node->first + node->count; ++i)
    {
      const Id id = this->Order[static_cast<std::size_t>(i)];
      node->box.Add(BoxOf(this->Points, this->Triangles[static_cast<std::size_t>(id)]));
    }
    if (node->HasChildren())
    {
      node->box.Add(this->Nodes[static_cast<std::size_t>(node->Left())].box);
      node->box.Add(this->Nodes[static_cast<std::size_t>(node->Right())].box);
    }
  }
}

std::size_t TriangleTree::BoxesOfLeaf(const Node& leaf, std::array<Box, tree::LeafSize>& boxes) const
{
  for (std::int64_t i = 0; i < leaf.count; ++i)
  {
    const Id id = this->Order[static_cast<std::size_t>(leaf.first + i)];
    boxes[static_cast<std::size_t>(i)] = BoxOf(this->Points, this->Triangles[static_cast<std::size_t>(id)]);
  }
  return static_cast<std::size_t>(leaf.count);
}

TriangleTree::Closest TriangleTree::ClosestOnTriangle(Id triangle, const Vec3& p) const
{
  const Triangle& t = this->Triangles[static_cast<std::size_t>(triangle)];
  Closest found;
  found.triangle = triangle;
  found.distance2 = PointTriangleDistance2(
    p, this->Points[static_cast<std::size_t>(t[0])], this->Points[static_cast<std::size_t>(t[1])],
    this->Points[static_cast<std::size_t>(t[2])], found.point, found.weights);
  return found;
}

TriangleTree::Closest TriangleTree::ClosestPoint(const Vec3& p, double limit2) const
{
  struct Step
  {
    std::int64_t node;
    double distance2;
  };
  Closest best;
  best.distance2 = limit2;
  std::array<Step, tree::StackSize> stack;
  int top = 0;
  if (!this->Nodes.empty())
  {
    stack[static_cast<std::size_t>(top++)] = { 0, this->Nodes[0].box.Distance2(p) };
  }
  while (top > 0)
  {
    const Step step = stack[static_cast<std::size_t>(--top)];
    if (step.distance2 > best.distance2)
    {
      continue;
    }
    const Node& node = this->Nodes[static_cast<std::size_t>(step.node)];
    for (std::int64_t i = node.first; i < node.first + node.count; ++i)
    {
      const Id id = this->Order[static_cast<std::size_t>(i)];
      const Closest found = this->ClosestOnTriangle(id, p);
      const bool tie = found.distance2 == best.distance2 && (best.triangle < 0 || id < best.triangle);
      if (found.distance2 < best.distance2 || tie)
      {
        best = found;
      }
    }
    if (node.HasChildren())
    {
      Step near{ node.Left(), this->Nodes[static_cast<std::size_t>(node.Left())].box.Distance2(p) };
      Step far{ node.Right(), this->Nodes[static_cast<std::size_t>(node.Right())].box.Distance2(p) };
      if (far.distance2 < near.distance2)
      {
        std::swap(near, far);
      }
      stack[static_cast<std::size_t>(top++)] = far;
      stack[static_cast<std::size_t>(top++)] = near;
    }
  }
  return best.triangle < 0 ? Closest{} : best;
}

} // namespace lamina
