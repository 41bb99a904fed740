// SPDX-License-Identifier: BSD-3-Clause
// Meshes of other programs for ComparePeers.py: counts of points and tets, points, tets, a material each.
#pragma once

#include "Base/Types.h"

#include <array>
#include <fstream>
#include <string>
#include <vector>

namespace lamina
{

inline bool WritePeerMesh(const std::string& path, const std::vector<Vec3>& points,
                          const std::vector<std::array<Id, 4>>& tets, const std::vector<int>& materials)
{
  std::ofstream file(path, std::ios::binary);
  const auto put = [&](const void* data, std::size_t bytes)
  { file.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes)); };
  const Id counts[2] = { static_cast<Id>(points.size()), static_cast<Id>(tets.size()) };
  put(counts, sizeof counts);
  put(points.data(), points.size() * sizeof points[0]);
  put(tets.data(), tets.size() * sizeof tets[0]);
  put(materials.data(), materials.size() * sizeof materials[0]);
  return static_cast<bool>(file);
}

} // namespace lamina
