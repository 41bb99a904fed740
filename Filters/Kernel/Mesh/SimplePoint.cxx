// SPDX-License-Identifier: BSD-3-Clause
#include "SimplePoint.h"

#include <array>
#include <cstdlib>

namespace lamina
{

namespace
{

constexpr int Centre = 13;
constexpr Neighbourhood All = (1u << 27) - 1;

struct Tables
{
  std::array<Neighbourhood, 27> corners{}; ///< the 26-neighbours of each voxel, inside the block
  std::array<Neighbourhood, 27> faces{};   ///< the 6-neighbours
  Neighbourhood near18 = 0;                ///< voxels that share a face or an edge with the centre
  Neighbourhood near6 = 0;                 ///< a face

  Tables()
  {
    for (int a = 0; a < 27; ++a)
    {
      for (int b = 0; b < 27; ++b)
      {
        const int di = std::abs(a % 3 - b % 3);
        const int dj = std::abs(a / 3 % 3 - b / 3 % 3);
        const int dk = std::abs(a / 9 - b / 9);
        const bool near = di <= 1 && dj <= 1 && dk <= 1 && a != b;
        this->corners[static_cast<std::size_t>(a)] |= near ? 1u << b : 0;
        this->faces[static_cast<std::size_t>(a)] |= near && di + dj + dk == 1 ? 1u << b : 0;
        this->near18 |= a == Centre && near && di + dj + dk <= 2 ? 1u << b : 0;
      }
    }
    this->near6 = this->faces[Centre];
  }
};

const Tables& TheTables()
{
  static const Tables tables;
  return tables;
}

/// The pieces of `set` that hold a voxel of `contact`.
int CountPieces(Neighbourhood set, Neighbourhood contact, const std::array<Neighbourhood, 27>& neighbours)
{
  int pieces = 0;
  Neighbourhood left = set;
  while (const Neighbourhood seeds = left & contact)
  {
    Neighbourhood front = seeds & (~seeds + 1);
    Neighbourhood piece = front;
    while (front)
    {
      Neighbourhood grown = 0;
      for (int v = 0; v < 27; ++v)
      {
        grown |= (front >> v) & 1u ? neighbours[static_cast<std::size_t>(v)] : 0;
      }
      front = grown & set & ~piece;
      piece |= front;
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
  return CountPieces(set & around, around, TheTables().corners);
}

int PiecesOverFaces(Neighbourhood set)
{
  const Tables& tables = TheTables();
  return CountPieces(set & tables.near18, tables.near6, tables.faces);
}

} // namespace lamina
