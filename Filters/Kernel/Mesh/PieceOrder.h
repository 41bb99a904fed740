// SPDX-License-Identifier: BSD-3-Clause
// An order of pieces by size and place that another mesh of the same shape finds again.
#pragma once

#include "../Base/Types.h"

namespace lamina
{

/// What is known of a connected piece.
struct Piece
{
  double size = 0; ///< area
  Vec3 centre;
};

/// The order of the pieces: the largest first; sizes with no gap of a tenth between neighbours count as
/// equal, and equal ones are ordered by their centres along x, then y, then z, each in classes parted by gaps
/// of a hundredth of `extent` (the size of all). So small changes of size or place keep the order.
std::vector<std::size_t> OrderPieces(const std::vector<Piece>& pieces, double extent);

/// The diagonal of the points' box.
double ExtentOf(const std::vector<Vec3>& points);

} // namespace lamina
