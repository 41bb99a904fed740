// SPDX-License-Identifier: BSD-3-Clause
// The files that WriteRefinementInputs.py makes.
#pragma once

#include "Mesh/VolumeCorrection.h"

#include <fstream>
#include <vector>

namespace lamina
{

template<typename T>
std::vector<T> Take(std::ifstream& file, std::size_t count)
{
  std::vector<T> values(count);
  file.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
  return values;
}

/// A closed surface of material 1, whichever way its triangles run in the file.
inline TriangleComplex FromTriangles(std::ifstream& file)
{
  TriangleComplex surface;
  const auto counts = Take<Id>(file, 2);
  surface.points = Take<Vec3>(file, static_cast<std::size_t>(counts[0]));
  surface.triangles = Take<Triangle>(file, static_cast<std::size_t>(counts[1]));
  surface.materials.assign(surface.triangles.size(), { 1, 0 });
  if (MaterialVolumes(surface, { 1 })[0] < 0)
  {
    for (Triangle& t : surface.triangles)
    {
      std::swap(t[1], t[2]);
    }
  }
  return surface;
}

} // namespace lamina
