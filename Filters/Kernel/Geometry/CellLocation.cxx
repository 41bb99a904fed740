// SPDX-License-Identifier: BSD-3-Clause
#include "CellLocation.h"

#include "Predicates.h"

#include <algorithm>
#include <optional>

namespace lamina
{
namespace
{

constexpr double Near = 1e-9;

/// Value and derivatives of a cell's map.
struct Mapped
{
  Vec3 place;
  std::array<Vec3, 3> slopes;
};

Mapped MapWedge(const std::array<Vec3, 6>& p, const Vec3& at)
{
  const double w = 1 - at.x - at.y;
  const Vec3 bottom = w * p[0] + at.x * p[1] + at.y * p[2];
  const Vec3 top = w * p[3] + at.x * p[4] + at.y * p[5];
  return { (1 - at.z) * bottom + at.z * top,
           { { (1 - at.z) * (p[1] - p[0]) + at.z * (p[4] - p[3]),
               (1 - at.z) * (p[2] - p[0]) + at.z * (p[5] - p[3]), top - bottom } } };
}

/// In the coordinates (u (1-z), v (1-z), z), in which the map's slopes stay apart at the apex.
Mapped MapPyramid(const std::array<Vec3, 5>& p, const Vec3& at)
{
  const double scale = std::max(1 - at.z, 1e-12);
  const Vec3 a = p[1] - p[0];
  const Vec3 b = p[3] - p[0];
  const Vec3 c = p[0] - p[1] + p[2] - p[3];
  const double twist = at.x * at.y / scale;
  return { (1 - at.z) * p[0] + at.x * a + at.y * b + twist * c + at.z * p[4],
           { { a + (at.y / scale) * c, b + (at.x / scale) * c, p[4] - p[0] + (twist / scale) * c } } };
}

/// Newton's method from `at`; nothing if it does not settle.
template<typename Map>
std::optional<Vec3> Invert(Map&& map, const Vec3& target, Vec3 at)
{
  for (int step = 0; step < 40; ++step)
  {
    const Mapped here = map(at);
    const auto& s = here.slopes;
    const double det = Dot(Cross(s[0], s[1]), s[2]);
    if (det == 0 || !std::isfinite(det))
    {
      return std::nullopt;
    }
    const Vec3 rest = target - here.place;
    const Vec3 move{ Dot(Cross(rest, s[1]), s[2]) / det, Dot(Cross(s[0], rest), s[2]) / det,
                     Dot(Cross(s[0], s[1]), rest) / det };
    at += move;
    if (!IsFinite(at))
    {
      return std::nullopt;
    }
    if (Norm2(move) < 1e-24 * (1 + Norm2(at)))
    {
      return at;
    }
  }
  return std::nullopt;
}

Location Judge(double least)
{
  return least > Near ? Location::Inside : (least < -Near ? Location::Outside : Location::Border);
}

template<std::size_t N>
bool IsBoxedOut(const std::array<Vec3, N>& nodes, const Vec3& p)
{
  for (int k = 0; k < 3; ++k)
  {
    const auto less = [k](const Vec3& a, const Vec3& b) { return a[k] < b[k]; };
    const auto [low, high] = std::minmax_element(nodes.begin(), nodes.end(), less);
    if (p[k] < (*low)[k] || p[k] > (*high)[k])
    {
      return true;
    }
  }
  return false;
}

} // namespace

Location LocateInTet(const std::array<Vec3, 4>& n, const Vec3& p)
{
  if (IsBoxedOut(n, p))
  {
    return Location::Outside;
  }
  const int least = std::min({ Orientation(p, n[1], n[2], n[3]), Orientation(n[0], p, n[2], n[3]),
                               Orientation(n[0], n[1], p, n[3]), Orientation(n[0], n[1], n[2], p) });
  return least > 0 ? Location::Inside : (least < 0 ? Location::Outside : Location::Border);
}

Location LocateInWedge(const std::array<Vec3, 6>& nodes, const Vec3& p)
{
  if (IsBoxedOut(nodes, p))
  {
    return Location::Outside;
  }
  const auto at = Invert([&](const Vec3& u) { return MapWedge(nodes, u); }, p, { 1.0 / 3, 1.0 / 3, 0.5 });
  return at ? Judge(std::min({ at->x, at->y, 1 - at->x - at->y, at->z, 1 - at->z })) : Location::Border;
}

Location LocateInPyramid(const std::array<Vec3, 5>& nodes, const Vec3& p)
{
  if (IsBoxedOut(nodes, p))
  {
    return Location::Outside;
  }
  const auto at = Invert([&](const Vec3& u) { return MapPyramid(nodes, u); }, p, { 0.375, 0.375, 0.25 });
  return at ? Judge(std::min({ at->x, at->y, 1 - at->z - at->x, 1 - at->z - at->y, at->z }))
            : Location::Border;
}

} // namespace lamina
