// SPDX-License-Identifier: BSD-3-Clause
// Linear finite elements on cells of all types.
#pragma once

#include "../Mesh/VolumeMesh.h"

namespace lamina
{

/// The tetrahedra that stand for a cell, each with the weight of its volume. A wedge or pyramid is the mean
/// of its two splits by opposite diagonals: both sides of a quad then see the same function.
struct CellTets
{
  int count = 0;
  double weight = 1;
  std::array<std::array<Id, 4>, 6> tets;
};
CellTets TetsOfCell(const VolumeMesh& mesh, Id cell);

/// Volume of a tet and the gradients of its four linear functions; a flat tet has volume 0 and no gradients.
struct TetShape
{
  double volume = 0;
  std::array<Vec3, 4> gradients;
};
TetShape ShapeOf(const VolumeMesh& mesh, const std::array<Id, 4>& tet);

} // namespace lamina
