// SPDX-License-Identifier: BSD-3-Clause
#include "PieceOrder.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace lamina
{
namespace
{

using Order = std::vector<std::size_t>;
/// The value a criterion sorts by, and whether there is a gap between two neighbours in that order.
struct Criterion
{
  std::function<double(std::size_t)> value;
  std::function<bool(double, double)> isGap;
};

/// Sort [begin, end) by the criterion and each class of it by those that follow.
void SortBy(const std::vector<Criterion>& criteria, std::size_t level, Order::iterator begin,
            Order::iterator end)
{
  if (level == criteria.size() || end - begin < 2)
  {
    return;
  }
  const Criterion& c = criteria[level];
  std::sort(begin, end,
            [&](std::size_t a, std::size_t b)
            { return c.value(a) != c.value(b) ? c.value(a) < c.value(b) : a < b; });
  for (auto first = begin; first != end;)
  {
    auto last = first + 1;
    while (last != end && !c.isGap(c.value(*(last - 1)), c.value(*last)))
    {
      ++last;
    }
    SortBy(criteria, level + 1, first, last);
    first = last;
  }
}

} // namespace

std::vector<std::size_t> OrderPieces(const std::vector<Piece>& pieces, double extent)
{
  std::vector<Criterion> criteria;
  criteria.push_back(
    { [&](std::size_t i) { return -pieces[i].size; }, [](double a, double b) { return -a > 1.1 * -b; } });
  for (int axis = 0; axis < 3; ++axis)
  {
    criteria.push_back({ [&pieces, axis](std::size_t i) { return pieces[i].centre[axis]; },
                         [extent](double a, double b) { return b - a > 0.01 * extent; } });
  }
  Order order(pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  SortBy(criteria, 0, order.begin(), order.end());
  return order;
}

double ExtentOf(const std::vector<Vec3>& points)
{
  Vec3 low = points.empty() ? Vec3{} : points.front();
  Vec3 high = low;
  for (const Vec3& p : points)
  {
    low = { std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z) };
    high = { std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z) };
  }
  return Norm(high - low);
}

} // namespace lamina
