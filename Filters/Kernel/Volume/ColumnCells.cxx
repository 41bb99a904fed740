// SPDX-License-Identifier: BSD-3-Clause
#include "ColumnCells.h"

#include "../Geometry/Quality.h"

#include <algorithm>

namespace lamina
{

namespace
{

struct Corner
{
  ColumnNode low;
  ColumnNode high;
  bool moves;
};

/// Three tets of the wedge on corners sorted by wall node; collapsed ones are left out. `flip` undoes an odd
/// sort.
int SplitIntoTets(std::array<Corner, 3> c, std::array<ColumnCell, 3>& cells)
{
  bool flip = false;
  for (int pass = 0; pass < 2; ++pass)
  {
    for (std::size_t i = 0; i < 2; ++i)
    {
      if (c[i].low.node > c[i + 1].low.node)
      {
        std::swap(c[i], c[i + 1]);
        flip = !flip;
      }
    }
  }
  int count = 0;
  const auto add = [&](ColumnNode p, ColumnNode q, ColumnNode r, ColumnNode s)
  {
    if (flip)
    {
      std::swap(q, r);
    }
    cells[static_cast<std::size_t>(count++)] = { CellType::Tetrahedron, { { p, q, r, s } } };
  };
  if (c[2].moves)
  {
    add(c[0].low, c[1].low, c[2].low, c[2].high);
  }
  if (c[1].moves)
  {
    add(c[0].low, c[1].low, c[2].high, c[1].high);
  }
  if (c[0].moves)
  {
    add(c[0].low, c[1].high, c[2].high, c[0].high);
  }
  return count;
}

/// One wedge, pyramid or tet.
int OneCell(const std::array<Corner, 3>& c, int moving, ColumnCell& cell)
{
  if (moving == 3)
  {
    cell = { CellType::Wedge, { { c[0].low, c[2].low, c[1].low, c[0].high, c[2].high, c[1].high } } };
    return 1;
  }
  // Turn the triangle so that the odd one out comes first.
  std::size_t odd = 0;
  while (c[odd].moves != (moving == 1))
  {
    ++odd;
  }
  const Corner& p = c[odd];
  const Corner& q = c[(odd + 1) % 3];
  const Corner& r = c[(odd + 2) % 3];
  if (moving == 2)
  {
    cell = { CellType::Pyramid, { { q.low, q.high, r.high, r.low, p.low } } };
  }
  else
  {
    cell = { CellType::Tetrahedron, { { p.low, q.low, r.low, p.high } } };
  }
  return 1;
}

} // namespace

int CellsOfTriangle(const Wall& wall, const Columns& columns, Id triangle, int layer, ColumnCells kind,
                    std::array<ColumnCell, 3>& cells)
{
  const Triangle& t = wall.triangles[static_cast<std::size_t>(triangle)];
  std::array<Corner, 3> corners;
  int moving = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const bool moves = !columns.Stopped(t[i]);
    corners[i] = { { t[i], moves ? layer - 1 : 0 }, { t[i], moves ? layer : 0 }, moves };
    moving += moves ? 1 : 0;
  }
  if (moving == 0)
  {
    return 0;
  }
  return kind == ColumnCells::Tets ? SplitIntoTets(corners, cells) : OneCell(corners, moving, cells[0]);
}

double QualityOf(const Wall& wall, const Columns& columns, const ColumnCell& cell)
{
  const auto at = [&](std::size_t i) { return columns.Place(wall, cell.nodes[i].node, cell.nodes[i].layer); };
  switch (cell.type)
  {
    case CellType::Wedge:
    {
      const std::array<Vec3, 6> nodes{ { at(0), at(1), at(2), at(3), at(4), at(5) } };
      const double quality = WedgeQuality(nodes);
      return WedgeSplitsAreValid(nodes) ? quality : std::min(0.0, quality);
    }
    case CellType::Pyramid:
    {
      const std::array<Vec3, 5> nodes{ { at(0), at(1), at(2), at(3), at(4) } };
      return PyramidIsValid(nodes) ? PyramidQuality(nodes) : -1;
    }
    default:
      return TetQuality(at(0), at(1), at(2), at(3));
  }
}

} // namespace lamina
