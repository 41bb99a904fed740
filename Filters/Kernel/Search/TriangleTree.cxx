// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleTree.h"

#include <numeric>

namespace lamina
{
namespace
{

constexpr std::int64_t LeafSize = 4;
constexpr int BinCount = 16;

double HalfArea(const Box& box)
{
  const Vec3 e = box.high - box.low;
  return e.x < 0 ? 0 : e.x * e.y + e.y * e.z + e.z * e.x;
}

/// What the build needs of a triangle.
struct Item
{
  Box box;
  Vec3 centre;
  Id id = 0;
};

struct Bin
{
  Box box;
  std::int64_t count = 0;
};

int BinOf(const Item& item, const Box& centres, int axis)
{
  const double extent = centres.high[axis] - centres.low[axis];
  const int bin = static_cast<int>(BinCount * ((item.centre[axis] - centres.low[axis]) / extent));
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
std::int64_t Part(std::vector<Item>& items, std::int64_t begin, std::int64_t end, int depth)
{
  Box centres;
  for (std::int64_t i = begin; i < end; ++i)
  {
    centres.Add(items[static_cast<std::size_t>(i)].centre);
  }
  const int axis = LongestAxis(centres);
  if (depth < tree::SplitByCost && centres.high[axis] > centres.low[axis])
  {
    std::array<Bin, BinCount> bins;
    for (std::int64_t i = begin; i < end; ++i)
    {
      const Item& item = items[static_cast<std::size_t>(i)];
      Bin& bin = bins[static_cast<std::size_t>(BinOf(item, centres, axis))];
      bin.box.Add(item.box);
      ++bin.count;
    }
    const int last = CheapestSplit(bins);
    if (last >= 0)
    {
      const auto middle =
        std::stable_partition(items.begin() + begin, items.begin() + end,
                              [&](const Item& item) { return BinOf(item, centres, axis) <= last; });
      return middle - items.begin();
    }
  }
  const std::int64_t middle = begin + (end - begin) / 2;
  std::nth_element(items.begin() + begin, items.begin() + middle, items.begin() + end,
                   [axis](const Item& a, const Item& b) {
                     return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis] : a.id < b.id;
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
  std::vector<Item> items;
  items.reserve(this->Order.size());
  for (Id id : this->Order)
  {
    const Box box = BoxOf(this->Points, this->Triangles[static_cast<std::size_t>(id)]);
    items.push_back({ box, 0.5 * (box.low + box.high), id });
  }
  if (items.empty())
  {
    return;
  }
  struct Task
  {
    std::int64_t node;
    int depth;
  };
  Node root;
  root.end = static_cast<std::int64_t>(items.size());
  this->Nodes.reserve(items.size());
  this->Nodes.push_back(root);
  std::vector<Task> tasks{ { 0, 0 } };
  while (!tasks.empty())
  {
    const Task task = tasks.back();
    tasks.pop_back();
    Node& node = this->Nodes[static_cast<std::size_t>(task.node)];
    if (node.end - node.begin <= LeafSize)
    {
      continue;
    }
    Node left;
    Node right;
    left.begin = node.begin;
    left.end = right.begin = Part(items, node.begin, node.end, task.depth);
    right.end = node.end;
    node.begin = node.end = 0;
    node.left = static_cast<std::int64_t>(this->Nodes.size());
    node.right = node.left + 1;
    tasks.push_back({ node.right, task.depth + 1 });
    tasks.push_back({ node.left, task.depth + 1 });
    this->Nodes.push_back(left);
    this->Nodes.push_back(right);
  }
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    this->Order[i] = items[i].id;
  }
  this->Refit();
}

void TriangleTree::Refit()
{
  // Children stand behind their parents.
  for (auto node = this->Nodes.rbegin(); node != this->Nodes.rend(); ++node)
  {
    node->box = Box{};
    for (std::int64_t i = node->begin; i < node->end; ++i)
    {
      const Id id = this->Order[static_cast<std::size_t>(i)];
      node->box.Add(BoxOf(this->Points, this->Triangles[static_cast<std::size_t>(id)]));
    }
    if (node->left >= 0)
    {
      node->box.Add(this->Nodes[static_cast<std::size_t>(node->left)].box);
      node->box.Add(this->Nodes[static_cast<std::size_t>(node->right)].box);
    }
  }
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
    for (std::int64_t i = node.begin; i < node.end; ++i)
    {
      const Id id = this->Order[static_cast<std::size_t>(i)];
      const Triangle& t = this->Triangles[static_cast<std::size_t>(id)];
      Closest found;
      found.triangle = id;
      found.distance2 = PointTriangleDistance2(
        p, this->Points[static_cast<std::size_t>(t[0])], this->Points[static_cast<std::size_t>(t[1])],
        this->Points[static_cast<std::size_t>(t[2])], found.point, found.weights);
      const bool tie = found.distance2 == best.distance2 && (best.triangle < 0 || id < best.triangle);
      if (found.distance2 < best.distance2 || tie)
      {
        best = found;
      }
    }
    if (node.left >= 0)
    {
      Step near{ node.left, this->Nodes[static_cast<std::size_t>(node.left)].box.Distance2(p) };
      Step far{ node.right, this->Nodes[static_cast<std::size_t>(node.right)].box.Distance2(p) };
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

namespace
{

/// Parameter in [0, 1] of the point of segment (a, b) closest to p.
double ClosestOnSegment(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const Vec3 edge = b - a;
  const double length2 = Norm2(edge);
  return length2 > 0 ? std::clamp(Dot(p - a, edge) / length2, 0.0, 1.0) : 0.0;
}

} // namespace

double PointTriangleDistance2(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, Vec3& closest,
                              std::array<double, 3>& weights)
{
  const Vec3 n = Cross(b - a, c - a);
  const double area2 = Norm2(n);
  if (area2 > 0)
  {
    const double wa = Dot(Cross(c - b, p - b), n) / area2;
    const double wb = Dot(Cross(a - c, p - c), n) / area2;
    const double wc = 1 - wa - wb;
    if (wa >= 0 && wb >= 0 && wc >= 0)
    {
      weights = { { wa, wb, wc } };
      closest = wa * a + wb * b + wc * c;
      return Norm2(p - closest);
    }
  }
  // Outside the prism over the triangle: the nearest of the three edges.
  const std::array<const Vec3*, 3> corners{ { &a, &b, &c } };
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    const double t = ClosestOnSegment(p, *corners[i], *corners[j]);
    const Vec3 q = t < 1 ? *corners[i] + t * (*corners[j] - *corners[i]) : *corners[j];
    const double d2 = Norm2(p - q);
    if (d2 < best)
    {
      best = d2;
      closest = q;
      weights = { { 0, 0, 0 } };
      weights[i] = 1 - t;
      weights[j] = t;
    }
  }
  return best;
}

double RayTriangle(const Vec3& origin, const Vec3& direction, const Vec3& a, const Vec3& b, const Vec3& c)
{
  // Rounding must not let a ray through between two triangles: each is taken a trifle larger than it is.
  constexpr double slack = 1e-12;
  const double miss = std::numeric_limits<double>::quiet_NaN();
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const Vec3 h = Cross(direction, v);
  const double det = Dot(u, h);
  if (det == 0)
  {
    return miss;
  }
  const Vec3 s = origin - a;
  const Vec3 q = Cross(s, u);
  const double beta = Dot(s, h) / det;
  const double gamma = Dot(direction, q) / det;
  return beta >= -slack && gamma >= -slack && beta + gamma <= 1 + slack ? Dot(v, q) / det : miss;
}

} // namespace lamina
