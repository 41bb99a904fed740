// SPDX-License-Identifier: BSD-3-Clause
#include "RepairCost.h"

#include <algorithm>
#include <array>
#include <bitset>

namespace lamina
{

namespace
{

using Place = LabelLattice::Place;
constexpr Id WindowSize = 7;
constexpr Id Reach = WindowSize / 2;
constexpr unsigned long long SlabVoxels = (1ull << (WindowSize * WindowSize)) - 1;
/// Voxels of a 7x7x7 window, a word for each k, bit i + 7 j. The last word, empty, stands below and above.
using Window = std::array<unsigned long long, WindowSize + 1>;

/// A fragment of a diagonal wall reaches through the window as one row, or two; pieces of more are bodies.
constexpr std::size_t LargeFragment = 14;
constexpr std::size_t SmallBody = 40;
constexpr double CostOfNewContact = 3;
/// For each face more between unlike voxels: a rough border makes a poor surface.
constexpr double CostOfRoughness = 0.04;
constexpr Neighbourhood Faces = (1u << 4) | (1u << 10) | (1u << 12) | (1u << 14) | (1u << 16) | (1u << 22);
/// The last change that closes a wall parts what touched across its edges: hardly a cut.
constexpr double ShareOfClosing = 0.1;
/// Where nothing else tells them apart, the label with more neighbours gives way.
constexpr double CostOfMinority = 0.05;

/// The voxels of a slab whose i is the first, or the last.
unsigned long long ColumnOf(Id i)
{
  unsigned long long column = 0;
  for (Id j = 0; j < WindowSize; ++j)
  {
    column |= 1ull << (i + WindowSize * j);
  }
  return column;
}

/// Grow a piece of `set` over faces until it is whole.
void Grow(const Window& set, Window& piece)
{
  static const unsigned long long notFirst = SlabVoxels & ~ColumnOf(0);
  static const unsigned long long notLast = SlabVoxels & ~ColumnOf(WindowSize - 1);
  for (bool again = true; again;)
  {
    again = false;
    for (std::size_t k = 0; k < static_cast<std::size_t>(WindowSize); ++k)
    {
      const unsigned long long own = piece[k];
      const unsigned long long near =
        own | ((own & notLast) << 1) | ((own & notFirst) >> 1) | (own << WindowSize) | (own >> WindowSize) |
        piece[k == 0 ? static_cast<std::size_t>(WindowSize) : k - 1] | piece[k + 1];
      piece[k] = near & set[k];
      again = again || piece[k] != own;
    }
  }
}

std::size_t CountVoxels(const Window& set)
{
  std::size_t count = 0;
  for (const unsigned long long slab : set)
  {
    count += std::bitset<64>(slab).count();
  }
  return count;
}

/// The image as it came.
class OriginalView
{
public:
  OriginalView(const LabelLattice& lattice, const FirstLabels& labels)
    : Lattice(lattice)
    , Labels(labels)
  {
  }
  int Label(const Place& v) const
  {
    return this->Lattice.IsVoxel(v) ? this->Labels.Of(this->Lattice.VoxelIndex(v)) : 0;
  }
  bool IsVoxel(const Place& v) const { return this->Lattice.IsVoxel(v); }
  /// Of seven voxels along i, those that carry a label.
  unsigned RowWith(const Place& first, int label) const
  {
    const Place& size = this->Lattice.Size();
    unsigned set = 0;
    const bool inside = first[1] >= 0 && first[2] >= 0 && first[1] < size[1] && first[2] < size[2];
    const Id row = inside ? this->Lattice.VoxelIndex(first) : 0;
    for (Id n = 0; n < WindowSize; ++n)
    {
      const Id i = first[0] + n;
      const int own = inside && i >= 0 && i < size[0] ? this->Labels.Of(row + n) : 0;
      set |= own == label ? 1u << n : 0u;
    }
    return set;
  }
  /// The 26 neighbours that carry a label.
  Neighbourhood With(const Place& v, int label) const
  {
    Neighbourhood set = 0;
    for (Id n = 0; n < 27; ++n)
    {
      const Place next{ v[0] + n % 3 - 1, v[1] + n / 3 % 3 - 1, v[2] + n / 9 - 1 };
      set |= this->Label(next) == label ? 1u << n : 0u;
    }
    return set & ~(1u << 13);
  }

private:
  const LabelLattice& Lattice;
  const FirstLabels& Labels;
};

/// The voxels of a window that carry a label, but for the middle.
Window WindowOf(const OriginalView& original, const Place& voxel, int label)
{
  Window window{};
  for (Id k = 0; k < WindowSize; ++k)
  {
    unsigned long long slab = 0;
    for (Id j = 0; j < WindowSize; ++j)
    {
      const Place first{ voxel[0] - Reach, voxel[1] + j - Reach, voxel[2] + k - Reach };
      slab |= static_cast<unsigned long long>(original.RowWith(first, label)) << (WindowSize * j);
    }
    window[static_cast<std::size_t>(k)] = slab;
  }
  window[Reach] &= ~(1ull << (Reach + WindowSize * Reach));
  return window;
}

/// The pieces, over faces and within the window, that share a face with the voxel.
struct WindowPieces
{
  int count = 0;
  std::size_t second = 0; ///< voxels of the second largest
};

WindowPieces PiecesAround(const OriginalView& original, const Place& voxel, int label)
{
  Window left = WindowOf(original, voxel, label);
  WindowPieces pieces;
  std::size_t largest = 0;
  for (const Place& face : { Place{ 3, 3, 2 }, Place{ 3, 2, 3 }, Place{ 2, 3, 3 }, Place{ 4, 3, 3 },
                             Place{ 3, 4, 3 }, Place{ 3, 3, 4 } })
  {
    const std::size_t slab = static_cast<std::size_t>(face[2]);
    Window piece{};
    piece[slab] = left[slab] & (1ull << (face[0] + WindowSize * face[1]));
    if (piece[slab] == 0)
    {
      continue;
    }
    Grow(left, piece);
    for (std::size_t k = 0; k < piece.size(); ++k)
    {
      left[k] &= ~piece[k];
    }
    const std::size_t size = CountVoxels(piece);
    ++pieces.count;
    pieces.second = std::max(pieces.second, std::min(size, largest));
    largest = std::max(largest, size);
  }
  return pieces;
}

int CountBits(Neighbourhood set)
{
  int count = 0;
  for (; set; set &= set - 1)
  {
    ++count;
  }
  return count;
}

/// 0: only fragments are joined; 1: bodies are.
double Joined(const WindowPieces& pieces)
{
  return std::min(1.0,
                  std::max(0.0, (static_cast<double>(pieces.second) - static_cast<double>(LargeFragment)) /
                                  static_cast<double>(SmallBody - LargeFragment)));
}

/// The voxels of a window whose neighbours along one axis are in the set, too. Those at the window's end
/// count as outside.
Window ErodedInSlabs(Window set, Id step, unsigned long long notFirst, unsigned long long notLast)
{
  for (unsigned long long& slab : set)
  {
    slab &= ((slab & notLast) << step) & ((slab & notFirst) >> step);
  }
  return set;
}

/// Whether one of 27 voxels around and at a voxel is the middle of 3x3x3 of the label: else what it is part
/// of is nowhere three voxels thick here.
bool ReachesBody(const OriginalView& original, const Place& voxel, int label)
{
  constexpr unsigned long long core = 0x7ull << 16 | 0x7ull << 23 | 0x7ull << 30; // i and j from 2 to 4
  Window set = WindowOf(original, voxel, label);
  set[Reach] |= 1ull << (Reach + WindowSize * Reach);
  set = ErodedInSlabs(set, 1, SlabVoxels & ~ColumnOf(0), SlabVoxels & ~ColumnOf(WindowSize - 1));
  set = ErodedInSlabs(set, WindowSize, SlabVoxels, SlabVoxels);
  bool any = false;
  for (std::size_t k = 2; k < 5; ++k)
  {
    any = any || (set[k - 1] & set[k] & set[k + 1] & core) != 0;
  }
  return any;
}

/// Whether a voxel, its label's neighbours given, is part of something thin.
bool IsThin(const OriginalView& original, const Place& voxel, Neighbourhood same, int label)
{
  constexpr Neighbourhood block = 0x1bu | (0x1bu << 9); // 2x2x2 voxels
  bool full = false;
  for (const int first : { 0, 1, 3, 4, 9, 10, 12, 13 })
  {
    full = full || ((same | (1u << 13)) & (block << first)) == (block << first);
  }
  return !full || !ReachesBody(original, voxel, label);
}

/// Whether a voxel with one neighbour of its label is the end of something longer than the two.
bool IsTip(const OriginalView& original, const Place& voxel, Neighbourhood neighbour, int label)
{
  Id n = 0;
  while (!((neighbour >> n) & 1u))
  {
    ++n;
  }
  const Place next{ voxel[0] + n % 3 - 1, voxel[1] + n / 3 % 3 - 1, voxel[2] + n / 9 - 1 };
  return original.IsVoxel(next) && CountBits(original.With(next, label)) > 1;
}

/// Whether the label's neighbours of a voxel hang together by it alone, or it is the tip of a strand.
bool Cuts(const OriginalView& original, const Place& voxel, Neighbourhood losing, int label)
{
  return PiecesOverCorners(losing) > 1 || (CountBits(losing) == 1 && IsTip(original, voxel, losing, label));
}

} // namespace

const RepairCost::Harm& RepairCost::HarmOf(const LabelChange& change)
{
  constexpr Id labels = 65536;
  const Id key = this->Lattice.VoxelIndex(change.voxel) * labels + change.to;
  const auto mixed = static_cast<unsigned long long>(key) * 0x9e3779b97f4a7c15ull;
  Harm& harm = this->Harms[static_cast<std::size_t>(mixed >> 32) % HarmsKept];
  if (harm.key != key)
  {
    // A voxel that a change gave this label before counts as it came, too.
    const OriginalView original(this->Lattice, this->Original);
    const int first = original.Label(change.voxel);
    harm.key = key;
    const int parts = PiecesOverFaces(original.With(change.voxel, change.to));
    const WindowPieces pieces =
      parts > 1 ? PiecesAround(original, change.voxel, change.to) : WindowPieces{ parts, 0 };
    harm.joins = static_cast<float>(Joined(pieces));
    harm.bridges = pieces.count < parts;
    const Neighbourhood same = original.With(change.voxel, first);
    harm.cuts = first != change.to && Cuts(original, change.voxel, same, first);
    harm.thins = first != change.to && IsThin(original, change.voxel, same, first);
  }
  return harm;
}

double RepairCost::Of(const LabelChange& change, const VoxelFaults& around, const RepairPrices& prices)
{
  const Harm& harm = this->HarmOf(change);
  const Neighbourhood losing = around.Others(change.from);
  const double joins = prices.join * static_cast<double>(harm.joins);
  double cost = 1 + std::max(joins, harm.bridges ? prices.bridge : 0) + (harm.thins ? prices.thin : 0);
  if (harm.cuts)
  {
    cost += prices.cut;
  }
  else if (PiecesOverCorners(losing) > 1)
  {
    cost += ShareOfClosing * prices.cut;
  }
  if (CountBits(losing) < CountBits(around.Others(change.to)))
  {
    cost += CostOfMinority;
  }
  cost += CostOfRoughness * (CountBits(losing & Faces) - CountBits(around.Others(change.to) & Faces));
  for (int n = 1; n < around.LabelCount(); ++n)
  {
    if (!this->Known.Touch(change.to, around.LabelAt(n)))
    {
      return cost + CostOfNewContact;
    }
  }
  return cost;
}

} // namespace lamina
