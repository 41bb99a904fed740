// SPDX-License-Identifier: BSD-3-Clause
#include "RepairCost.h"

#include <algorithm>
#include <bitset>

namespace lamina
{

namespace
{

using Place = LabelLattice::Place;
/// Voxels of a 7x7x7 window, bit i + 7 j + 49 k.
constexpr std::size_t WindowSize = 7;
constexpr std::size_t WindowVoxels = WindowSize * WindowSize * WindowSize;
constexpr std::size_t WindowMiddle = WindowVoxels / 2;
using Window = std::bitset<WindowVoxels>;

/// A fragment of a diagonal wall reaches through the window as one row, or two; pieces of more are bodies.
constexpr std::size_t LargeFragment = 14;
constexpr std::size_t SmallBody = 40;
constexpr double CostOfNewContact = 3;
/// The last change that closes a wall parts what touched across its edges: hardly a cut.
constexpr double ShareOfClosing = 0.1;
/// Where nothing else tells them apart, the label with more neighbours gives way.
constexpr double CostOfMinority = 0.05;

struct WindowMasks
{
  Window first[3]; ///< voxels that have no neighbour below along the axis
  Window last[3];

  WindowMasks()
  {
    for (std::size_t v = 0; v < WindowVoxels; ++v)
    {
      const std::size_t place[3] = { v % WindowSize, v / WindowSize % WindowSize,
                                     v / (WindowSize * WindowSize) };
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        this->first[axis][v] = place[axis] == 0;
        this->last[axis][v] = place[axis] == WindowSize - 1;
      }
    }
  }
};

Window Grow(const Window& set)
{
  static const WindowMasks masks;
  constexpr std::size_t steps[3] = { 1, WindowSize, WindowSize * WindowSize };
  Window grown = set;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    grown |= (set & ~masks.last[axis]) << steps[axis];
    grown |= (set & ~masks.first[axis]) >> steps[axis];
  }
  return grown;
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

/// The second largest piece, over faces and within the window, of those that share a face with the voxel.
std::size_t SecondPiece(const OriginalView& original, const Place& voxel, int label)
{
  Window left;
  std::size_t n = 0;
  for (Id dk = -3; dk <= 3; ++dk)
  {
    for (Id dj = -3; dj <= 3; ++dj)
    {
      for (Id di = -3; di <= 3; ++di, ++n)
      {
        left[n] =
          n != WindowMiddle && original.Label({ voxel[0] + di, voxel[1] + dj, voxel[2] + dk }) == label;
      }
    }
  }
  std::size_t sizes[2] = { 0, 0 };
  for (const std::size_t seed : { WindowMiddle - 49, WindowMiddle - 7, WindowMiddle - 1, WindowMiddle + 1,
                                  WindowMiddle + 7, WindowMiddle + 49 })
  {
    if (!left[seed])
    {
      continue;
    }
    Window piece;
    piece[seed] = true;
    for (Window grown = Grow(piece) & left; grown != piece; grown = Grow(piece) & left)
    {
      piece = grown;
    }
    left &= ~piece;
    const std::size_t size = piece.count();
    sizes[1] = std::max(sizes[1], std::min(size, sizes[0]));
    sizes[0] = std::max(sizes[0], size);
  }
  return sizes[1];
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
double Joined(const OriginalView& original, const Place& voxel, int label)
{
  if (PiecesOverFaces(original.With(voxel, label)) < 2)
  {
    return 0;
  }
  const double size = static_cast<double>(SecondPiece(original, voxel, label));
  return std::min(1.0, std::max(0.0, (size - static_cast<double>(LargeFragment)) /
                                       static_cast<double>(SmallBody - LargeFragment)));
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
    harm.joins = static_cast<float>(Joined(original, change.voxel, change.to));
    harm.cuts = first != change.to &&
                Cuts(original, change.voxel, original.With(change.voxel, first), first);
  }
  return harm;
}

double RepairCost::Of(const LabelChange& change, const Surroundings& around, const RepairPrices& prices)
{
  const Harm& harm = this->HarmOf(change);
  const Neighbourhood losing = around.With(change.from);
  double cost = 1 + prices.join * static_cast<double>(harm.joins);
  if (harm.cuts)
  {
    cost += prices.cut;
  }
  else if (PiecesOverCorners(losing) > 1)
  {
    cost += ShareOfClosing * prices.cut;
  }
  if (CountBits(losing) < CountBits(around.With(change.to)))
  {
    cost += CostOfMinority;
  }
  for (std::size_t n = 0; n < 27; ++n)
  {
    if (n != 13 && around.labels[n] != change.from && !this->Known.Touch(change.to, around.labels[n]))
    {
      return cost + CostOfNewContact;
    }
  }
  return cost;
}

} // namespace lamina
