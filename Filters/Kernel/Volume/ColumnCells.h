// SPDX-License-Identifier: BSD-3-Clause
// The cells that stand between two layers of columns on a wall triangle.
#pragma once

#include "../Mesh/VolumeMesh.h"
#include "Columns.h"

namespace lamina
{

/// A node of a column: wall node and layer. A stopped column has but its wall node, layer 0.
struct ColumnNode
{
  Id node = 0;
  int layer = 0;
};

/// A cell by its column nodes, in VTK's order.
struct ColumnCell
{
  CellType type = CellType::Wedge;
  std::array<ColumnNode, 6> nodes;
};

/// The cells between layer - 1 and layer on a triangle: a wedge, or what is left of it where columns stopped;
/// with ColumnCells::Tets split into tets such that neighbours fit (diagonals start at the lower wall node).
int CellsOfTriangle(const Wall& wall, const Columns& columns, Id triangle, int layer, ColumnCells kind,
                    std::array<ColumnCell, 3>& cells);

/// Quality of a cell (Quality.h), not positive if it is invalid, or a wedge that has a split which is.
double QualityOf(const Wall& wall, const Columns& columns, const ColumnCell& cell);

} // namespace lamina
