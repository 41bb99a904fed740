// SPDX-License-Identifier: BSD-3-Clause
#include "Result.h"

#include <cstdio>

namespace lamina
{

std::string ToString(const Vec3& place)
{
  char text[96];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", place.x, place.y, place.z);
  return text;
}

std::string DescribePlaces(const std::vector<Vec3>& places)
{
  constexpr std::size_t shown = 3;
  std::string text;
  for (std::size_t i = 0; i < places.size() && i < shown; ++i)
  {
    text += (i == 0 ? " at " : ", ") + ToString(places[i]);
  }
  if (places.size() > shown)
  {
    text += " and " + std::to_string(places.size() - shown) + " more";
  }
  return text;
}

} // namespace lamina
