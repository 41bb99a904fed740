// SPDX-License-Identifier: BSD-3-Clause
#include "CellTets.h"

#include "../Geometry/Quality.h"

#include <cmath>

namespace lamina
{

CellTets TetsOfCell(const VolumeMesh& mesh, Id cell)
{
  // Both splits of the wedge have no cycle of diagonals; what one cuts from 0 to 4 the other cuts from 1
  // to 3.
  static constexpr int wedge[6][4] = { { 0, 1, 2, 5 }, { 0, 1, 5, 4 }, { 0, 4, 5, 3 },
                                       { 0, 1, 2, 3 }, { 1, 2, 3, 4 }, { 2, 3, 4, 5 } };
  static constexpr int pyramid[4][4] = { { 0, 1, 2, 4 }, { 0, 2, 3, 4 }, { 0, 1, 3, 4 }, { 1, 2, 3, 4 } };
  const Id* n = mesh.Cell(cell);
  CellTets parts;
  const auto fill = [&](const int(*table)[4], int count)
  {
    parts.count = count;
    parts.weight = 0.5;
    for (int t = 0; t < count; ++t)
    {
      for (std::size_t k = 0; k < 4; ++k)
      {
        parts.tets[static_cast<std::size_t>(t)][k] = n[table[t][k]];
      }
    }
  };
  switch (mesh.types[static_cast<std::size_t>(cell)])
  {
    case CellType::Wedge:
      fill(wedge, 6);
      break;
    case CellType::Pyramid:
      fill(pyramid, 4);
      break;
    default:
      parts.count = 1;
      parts.tets[0] = { { n[0], n[1], n[2], n[3] } };
  }
  return parts;
}

TetShape ShapeOf(const VolumeMesh& mesh, const std::array<Id, 4>& tet)
{
  std::array<Vec3, 4> p;
  for (std::size_t k = 0; k < 4; ++k)
  {
    p[k] = mesh.points[static_cast<std::size_t>(tet[k])];
  }
  const double six = 6 * TetVolume(p[0], p[1], p[2], p[3]);
  TetShape shape;
  if (six == 0)
  {
    return shape;
  }
  shape.volume = std::abs(six) / 6;
  shape.gradients[1] = Cross(p[2] - p[0], p[3] - p[0]) * (1 / six);
  shape.gradients[2] = Cross(p[3] - p[0], p[1] - p[0]) * (1 / six);
  shape.gradients[3] = Cross(p[1] - p[0], p[2] - p[0]) * (1 / six);
  shape.gradients[0] = -(shape.gradients[1] + shape.gradients[2] + shape.gradients[3]);
  return shape;
}

} // namespace lamina
