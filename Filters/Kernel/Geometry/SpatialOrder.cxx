// SPDX-License-Identifier: BSD-3-Clause
#include "SpatialOrder.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace lamina
{

namespace
{

/// The lower 21 bits, each followed by two zeros.
std::uint64_t Spread(std::uint64_t bits)
{
  bits &= 0x1fffff;
  bits = (bits | bits << 32) & 0x1f00000000ffff;
  bits = (bits | bits << 16) & 0x1f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

} // namespace

std::vector<Id> SpatialOrder(const std::vector<Vec3>& points)
{
  if (points.empty())
  {
    return {};
  }
  Vec3 low = points[0];
  Vec3 high = points[0];
  for (const Vec3& p : points)
  {
    low = { std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z) };
    high = { std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z) };
  }
  const double extent = std::max({ high.x - low.x, high.y - low.y, high.z - low.z });
  const double scale = extent > 0 ? 2097151 / extent : 0;
  std::vector<std::pair<std::uint64_t, Id>> codes;
  codes.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto bits = [&](double x, double from)
    { return Spread(static_cast<std::uint64_t>((x - from) * scale)); };
    const Vec3& p = points[i];
    codes.push_back({ bits(p.x, low.x) | bits(p.y, low.y) << 1 | bits(p.z, low.z) << 2, static_cast<Id>(i) });
  }
  std::sort(codes.begin(), codes.end());
  std::vector<Id> order;
  order.reserve(codes.size());
  for (const auto& code : codes)
  {
    order.push_back(code.second);
  }
  return order;
}

} // namespace lamina
