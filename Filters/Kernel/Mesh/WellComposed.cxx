// SPDX-License-Identifier: BSD-3-Clause
#include "WellComposed.h"

#include <algorithm>
#include <deque>
#include <map>
#include <set>

namespace lamina
{

bool IsCriticalEdge(int p0, int p1, int p2, int p3)
{
  return (p0 == p2 && p0 != p1 && p0 != p3) || (p1 == p3 && p1 != p0 && p1 != p2);
}

namespace
{

/// The labels of 2x2x2 voxels, bit 0 of the index along i, bit 1 along j, bit 2 along k.
using Block = std::array<int, 8>;

/// A body diagonal whose two ends share a label that no other voxel of the block has, or whose six other
/// voxels share a label that neither end has. Free of critical edges these are the only corner contacts.
bool IsCriticalCorner(const Block& b)
{
  for (int i = 0; i < 4; ++i)
  {
    const int label = b[static_cast<std::size_t>(i)];
    const int far = b[static_cast<std::size_t>(7 - i)];
    int others[6];
    int n = 0;
    for (int q = 0; q < 8; ++q)
    {
      if (q != i && q != 7 - i)
      {
        others[n++] = b[static_cast<std::size_t>(q)];
      }
    }
    const bool alone =
      label == far && std::none_of(others, others + 6, [label](int l) { return l == label; });
    const bool same = std::all_of(others, others + 6, [&](int l) { return l == others[0]; });
    if (alone || (same && label != others[0] && far != others[0]))
    {
      return true;
    }
  }
  return false;
}

int CountCritical(const Block& b)
{
  // The six lattice edges at the block's centre: the 2x2x1 halves, in cyclic order.
  static const int cycles[6][4] = { { 0, 1, 3, 2 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
                                    { 2, 3, 7, 6 }, { 0, 2, 6, 4 }, { 1, 3, 7, 5 } };
  int count = 0;
  for (const auto& c : cycles)
  {
    count += IsCriticalEdge(b[static_cast<std::size_t>(c[0])], b[static_cast<std::size_t>(c[1])],
                            b[static_cast<std::size_t>(c[2])], b[static_cast<std::size_t>(c[3])])
               ? 1
               : 0;
  }
  return count + (IsCriticalCorner(b) ? 1 : 0);
}

/// The search for a well-composed image near the given one.
class Repair
{
public:
  Repair(LabelImage& image)
    : Image(image)
    , Size(image.grid.size)
  {
  }

  /// Lattice point (i, j, k) is the corner below voxel (i, j, k); i runs from 0 to size[0].
  int CriticalAt(Id i, Id j, Id k) const { return CountCritical(this->BlockAt(i, j, k)); }
  bool IsMixed(Id i, Id j, Id k) const
  {
    const Block b = this->BlockAt(i, j, k);
    return std::any_of(b.begin() + 1, b.end(), [&](int l) { return l != b[0]; });
  }
  int Label(Id i, Id j, Id k) const
  {
    const bool inside =
      i >= 0 && j >= 0 && k >= 0 && i < this->Size[0] && j < this->Size[1] && k < this->Size[2];
    return inside ? this->Image.labels[static_cast<std::size_t>(this->Image.grid.Index(i, j, k))] : 0;
  }
  Block BlockAt(Id i, Id j, Id k) const
  {
    Block b;
    for (int q = 0; q < 8; ++q)
    {
      b[static_cast<std::size_t>(q)] = this->Label(i - 1 + (q & 1), j - 1 + ((q >> 1) & 1), k - 1 + (q >> 2));
    }
    return b;
  }
  std::vector<std::array<Id, 3>> CriticalPoints(Monitor& monitor) const;
  std::vector<Id> Run(Monitor& monitor);

private:
  using Voxel = std::array<Id, 3>;
  struct Flip
  {
    Voxel voxel{ { 0, 0, 0 } };
    int label = 0;
    int change = 0; ///< of the number of critical configurations
    int cost = 0;   ///< among equals
  };

  bool Inside(const Voxel& v) const
  {
    return v[0] >= 0 && v[1] >= 0 && v[2] >= 0 && v[0] < this->Size[0] && v[1] < this->Size[1] &&
           v[2] < this->Size[2];
  }
  int& At(const Voxel& v)
  {
    return this->Image.labels[static_cast<std::size_t>(this->Image.grid.Index(v[0], v[1], v[2]))];
  }
  int CriticalAround(const Voxel& v) const;
  int Contacts(const Voxel& v, int label) const;
  void LearnRanksAndContacts();
  Flip BestFlip(const std::array<Id, 3>& point);
  Flip ClimbingFlip(const std::array<Id, 3>& point);

  LabelImage& Image;
  std::array<Id, 3> Size;
  std::map<int, int> Rank;             ///< 0 the rarest label; ties by id
  std::set<std::pair<int, int>> Known; ///< pairs of labels in contact in the input
};

std::vector<std::array<Id, 3>> Repair::CriticalPoints(Monitor& monitor) const
{
  std::vector<std::vector<std::array<Id, 3>>> slices(static_cast<std::size_t>(this->Size[2] + 1));
  monitor.For(this->Size[2] + 1, 4,
              [&](Id begin, Id end)
              {
                for (Id k = begin; k < end; ++k)
                {
                  for (Id j = 0; j <= this->Size[1]; ++j)
                  {
                    for (Id i = 0; i <= this->Size[0]; ++i)
                    {
                      if (this->IsMixed(i, j, k) && this->CriticalAt(i, j, k) > 0)
                      {
                        slices[static_cast<std::size_t>(k)].push_back({ i, j, k });
                      }
                    }
                  }
                }
              });
  std::vector<std::array<Id, 3>> all;
  for (const auto& slice : slices)
  {
    all.insert(all.end(), slice.begin(), slice.end());
  }
  return all;
}

int Repair::CriticalAround(const Voxel& v) const
{
  int count = 0;
  for (int q = 0; q < 8; ++q)
  {
    count += this->CriticalAt(v[0] + (q & 1), v[1] + ((q >> 1) & 1), v[2] + (q >> 2));
  }
  return count;
}

/// Neighbours that `label` at v would touch though such materials touch nowhere in the input (heavily), plus
/// the 6-neighbours of another label: a flip should bring no new neighbours and roughen nothing.
int Repair::Contacts(const Voxel& v, int label) const
{
  int cost = 0;
  for (Id dk = -1; dk <= 1; ++dk)
  {
    for (Id dj = -1; dj <= 1; ++dj)
    {
      for (Id di = -1; di <= 1; ++di)
      {
        const int other = this->Label(v[0] + di, v[1] + dj, v[2] + dk);
        if (other == label)
        {
          continue;
        }
        cost += this->Known.count({ std::min(label, other), std::max(label, other) }) ? 0 : 1000;
        cost += std::abs(di) + std::abs(dj) + std::abs(dk) == 1 ? 1 : 0;
      }
    }
  }
  return cost;
}

void Repair::LearnRanksAndContacts()
{
  std::map<int, Id> frequency;
  for (Id k = 0; k <= this->Size[2]; ++k)
  {
    for (Id j = 0; j <= this->Size[1]; ++j)
    {
      for (Id i = 0; i <= this->Size[0]; ++i)
      {
        const Block b = this->BlockAt(i, j, k);
        ++frequency[b[7]];
        for (int p : b)
        {
          for (int q : b)
          {
            if (p < q)
            {
              this->Known.insert({ p, q });
            }
          }
        }
      }
    }
  }
  std::vector<std::pair<Id, int>> order;
  for (const auto& item : frequency)
  {
    order.push_back({ item.second, item.first });
  }
  std::sort(order.begin(), order.end());
  for (std::size_t r = 0; r < order.size(); ++r)
  {
    this->Rank[order[r].second] = static_cast<int>(r);
  }
}

Repair::Flip Repair::BestFlip(const std::array<Id, 3>& point)
{
  Flip best;
  bool found = false;
  const Block block = this->BlockAt(point[0], point[1], point[2]);
  for (int q = 0; q < 8; ++q)
  {
    const Voxel v{ point[0] - 1 + (q & 1), point[1] - 1 + ((q >> 1) & 1), point[2] - 1 + (q >> 2) };
    if (!this->Inside(v))
    {
      continue;
    }
    const int before = this->CriticalAround(v);
    const int own = this->At(v);
    const std::set<int> candidates(block.begin(), block.end());
    for (int label : candidates)
    {
      if (label == own)
      {
        continue;
      }
      const int ownCost = this->Contacts(v, own);
      this->At(v) = label;
      const Flip flip{ v, label, this->CriticalAround(v) - before, this->Contacts(v, label) - ownCost };
      this->At(v) = own;
      // A forbidden contact outweighs any number of critical configurations: those can be repaired elsewhere.
      const auto key = [](const Flip& f)
      { return std::make_pair(f.cost >= 500 ? 1 : 0, std::make_pair(f.change, f.cost)); };
      if (!found || key(flip) < key(best))
      {
        best = flip;
        found = true;
      }
    }
  }
  return best;
}

/// A flip that raises the rank of a voxel of a critical block: the one whose remaining critical count is
/// least.
Repair::Flip Repair::ClimbingFlip(const std::array<Id, 3>& point)
{
  Flip best;
  bool found = false;
  const Block block = this->BlockAt(point[0], point[1], point[2]);
  for (int q = 0; q < 8; ++q)
  {
    const Voxel v{ point[0] - 1 + (q & 1), point[1] - 1 + ((q >> 1) & 1), point[2] - 1 + (q >> 2) };
    if (!this->Inside(v))
    {
      continue;
    }
    const int own = this->At(v);
    for (int label : block)
    {
      if (this->Rank[label] <= this->Rank[own])
      {
        continue;
      }
      const int before = this->CriticalAround(v);
      this->At(v) = label;
      const Flip flip{ v, label, this->CriticalAround(v) - before, 0 };
      this->At(v) = own;
      if (!found || flip.change < best.change)
      {
        best = flip;
        found = true;
      }
    }
  }
  return best;
}

std::vector<Id> Repair::Run(Monitor& monitor)
{
  const std::vector<std::array<Id, 3>> start = this->CriticalPoints(monitor);
  if (start.empty())
  {
    return {};
  }
  this->LearnRanksAndContacts();
  std::set<Id> changed;
  std::map<Id, int> flips;
  std::deque<std::array<Id, 3>> work(start.begin(), start.end());
  while (!work.empty() && !monitor.Cancelled())
  {
    const std::array<Id, 3> point = work.front();
    work.pop_front();
    if (this->CriticalAt(point[0], point[1], point[2]) == 0)
    {
      continue;
    }
    Flip flip = this->BestFlip(point);
    const Id index = this->Image.grid.Index(flip.voxel[0], flip.voxel[1], flip.voxel[2]);
    // Each voxel may be changed twice by the free search; after that labels only climb, which must end.
    if (flip.change >= 0 || flip.cost >= 500 || ++flips[index] > 2)
    {
      flip = this->ClimbingFlip(point);
    }
    this->At(flip.voxel) = flip.label;
    changed.insert(this->Image.grid.Index(flip.voxel[0], flip.voxel[1], flip.voxel[2]));
    for (int q = 0; q < 8; ++q)
    {
      work.push_back({ flip.voxel[0] + (q & 1), flip.voxel[1] + ((q >> 1) & 1), flip.voxel[2] + (q >> 2) });
    }
  }
  return { changed.begin(), changed.end() };
}

} // namespace

std::vector<Id> FindCriticalVoxels(const LabelImage& image, Monitor& monitor)
{
  LabelImage& view = const_cast<LabelImage&>(image); // Repair only reads here
  const Repair repair(view);
  std::set<Id> voxels;
  for (const auto& point : repair.CriticalPoints(monitor))
  {
    for (int q = 0; q < 8; ++q)
    {
      const std::array<Id, 3> v{ point[0] - 1 + (q & 1), point[1] - 1 + ((q >> 1) & 1),
                                 point[2] - 1 + (q >> 2) };
      if (v[0] >= 0 && v[1] >= 0 && v[2] >= 0 && v[0] < image.grid.size[0] && v[1] < image.grid.size[1] &&
          v[2] < image.grid.size[2])
      {
        voxels.insert(image.grid.Index(v[0], v[1], v[2]));
      }
    }
  }
  return { voxels.begin(), voxels.end() };
}

std::vector<Id> MakeWellComposed(LabelImage& image, Monitor& monitor)
{
  return Repair(image).Run(monitor);
}

} // namespace lamina
