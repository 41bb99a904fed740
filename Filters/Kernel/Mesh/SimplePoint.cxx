// SPDX-License-Identifier: BSD-3-Clause
#include "SimplePoint.h"

namespace lamina
{

namespace
{

constexpr int Centre = 13;
constexpr Neighbourhood All = (1u << 27) - 1;

constexpr Neighbourhood Repeat(Neighbourhood row, int step, int count)
{
  return count == 0 ? 0u : row | (Repeat(row, step, count - 1) << step);
}

constexpr Neighbourhood FirstI = Repeat(1u, 3, 9); ///< i is 0
constexpr Neighbourhood LastI = FirstI << 2;
constexpr Neighbourhood FirstJ = Repeat(7u, 9, 3);
constexpr Neighbourhood LastJ = FirstJ << 6;

Neighbourhood AlongI(Neighbourhood set)
{
  return ((set & ~LastI) << 1) | ((set & ~FirstI) >> 1);
}
Neighbourhood AlongJ(Neighbourhood set)
{
  return ((set & ~LastJ) << 3) | ((set & ~FirstJ) >> 3);
}
Neighbourhood AlongK(Neighbourhood set)
{
  return ((set << 9) & All) | (set >> 9);
}

/// With the 6-neighbours of each voxel, inside the 27.
Neighbourhood GrownOverFaces(Neighbourhood set)
{
  return set | AlongI(set) | AlongJ(set) | AlongK(set);
}
/// With the 26-neighbours.
Neighbourhood GrownOverCorners(Neighbourhood set)
{
  const Neighbourhood rows = set | AlongI(set);
  const Neighbourhood slabs = rows | AlongJ(rows);
  return slabs | AlongK(slabs);
}

constexpr Neighbourhood Near6 = (1u << 4) | (1u << 10) | (1u << 12) | (1u << 14) | (1u << 16) | (1u << 22);
constexpr Neighbourhood CubeCorners = 0x45u | (0x45u << 18) | (1u << 8) | (1u << 26);
constexpr Neighbourhood Near18 = All & ~CubeCorners & ~(1u << Centre);

/// The pieces of `set` that hold a voxel of `contact`.
template<typename Grown>
int CountPieces(Neighbourhood set, Neighbourhood contact, const Grown& grown)
{
  int pieces = 0;
  Neighbourhood left = set;
  while (const Neighbourhood seeds = left & contact)
  {
    Neighbourhood piece = seeds & (~seeds + 1);
    for (Neighbourhood before = 0; piece != before;)
    {
      before = piece;
      piece = grown(piece) & set;
    }
    left &= ~piece;
    ++pieces;
  }
  return pieces;
}

} // namespace

int PiecesOverCorners(Neighbourhood set)
{
  const Neighbourhood around = All & ~(1u << Centre);
  return CountPieces(set & around, around, GrownOverCorners);
}

int PiecesOverFaces(Neighbourhood set)
{
  return CountPieces(set & Near18, Near6, GrownOverFaces);
}

} // namespace lamina
