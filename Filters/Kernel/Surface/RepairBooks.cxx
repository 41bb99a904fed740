// SPDX-License-Identifier: BSD-3-Clause
#include "RepairBooks.h"

#include <algorithm>

namespace lamina
{

namespace
{

using Voxel = std::array<Id, 3>;

enum class Fate
{
  Taken, ///< from the label it had
  Given  ///< to the label it has
};

class Bookkeeper
{
public:
  Bookkeeper(const LabelImage& first, const LabelImage& now, const std::vector<Id>& changed)
    : First(first)
    , Now(now)
    , Changed(changed)
  {
  }

  void Book(Fate fate, RepairBooks& books) const;

private:
  Voxel PlaceOf(Id v) const
  {
    const auto& s = this->Now.grid.size;
    return { v % s[0], v / s[0] % s[1], v / s[0] / s[1] };
  }
  bool IsInside(const Voxel& v) const
  {
    const auto& s = this->Now.grid.size;
    return v[0] >= 0 && v[1] >= 0 && v[2] >= 0 && v[0] < s[0] && v[1] < s[1] && v[2] < s[2];
  }
  std::size_t At(const Voxel& v) const
  {
    return static_cast<std::size_t>(this->Now.grid.Index(v[0], v[1], v[2]));
  }
  int LabelNow(const Voxel& v) const { return this->IsInside(v) ? this->Now.labels[this->At(v)] : 0; }
  /// The neighbour over face d, 2 * axis + 1 for the high side.
  static Voxel Neighbour(Voxel v, int d)
  {
    v[static_cast<std::size_t>(d / 2)] += d % 2 ? 1 : -1;
    return v;
  }
  static RepairClaim ClaimAt(const Voxel& v, int d, int material, double voxels)
  {
    return { d % 2 ? Neighbour(v, d) : v, d / 2, material, voxels };
  }
  int OwnerOf(std::size_t n, Fate fate) const
  {
    const auto v = static_cast<std::size_t>(this->Changed[n]);
    return fate == Fate::Taken ? this->First.labels[v] : this->Now.labels[v];
  }
  std::vector<int> FacesOf(std::size_t n, Fate fate) const;
  std::vector<std::size_t> NearestWithFaces(Fate fate) const;
  void BookInside(std::size_t n, RepairBooks& books) const;

  const LabelImage& First;
  const LabelImage& Now;
  const std::vector<Id>& Changed;
};

/// The faces of the n-th changed voxel beyond which (taken) or on whose near side (given) its owner stands.
std::vector<int> Bookkeeper::FacesOf(std::size_t n, Fate fate) const
{
  const Voxel v = this->PlaceOf(this->Changed[n]);
  const int owner = this->OwnerOf(n, fate);
  std::vector<int> faces;
  for (int d = 0; d < 6; ++d)
  {
    const bool isOwners = this->LabelNow(Neighbour(v, d)) == owner;
    if (isOwners == (fate == Fate::Taken))
    {
      faces.push_back(d);
    }
  }
  return faces;
}

/// For each changed voxel the nearest one of its owner's that has faces; itself where that is so, and the
/// number of changed voxels where there is none.
std::vector<std::size_t> Bookkeeper::NearestWithFaces(Fate fate) const
{
  const std::size_t count = this->Changed.size();
  std::vector<std::size_t> nearest(count, count);
  std::vector<std::size_t> queue;
  for (std::size_t n = 0; n < count; ++n)
  {
    if (!this->FacesOf(n, fate).empty())
    {
      nearest[n] = n;
      queue.push_back(n);
    }
  }
  for (std::size_t at = 0; at < queue.size(); ++at)
  {
    const std::size_t n = queue[at];
    const Voxel v = this->PlaceOf(this->Changed[n]);
    for (int d = 0; d < 6; ++d)
    {
      const Voxel next = Neighbour(v, d);
      if (!this->IsInside(next))
      {
        continue;
      }
      const auto found =
        std::lower_bound(this->Changed.begin(), this->Changed.end(), static_cast<Id>(this->At(next)));
      const auto m = static_cast<std::size_t>(found - this->Changed.begin());
      if (m < count && this->Changed[m] == static_cast<Id>(this->At(next)) && nearest[m] == count &&
          this->OwnerOf(m, fate) == this->OwnerOf(n, fate))
      {
        nearest[m] = nearest[n];
        queue.push_back(m);
      }
    }
  }
  return nearest;
}

/// A voxel deep inside the piece it was given to: any face of that piece will do.
void Bookkeeper::BookInside(std::size_t n, RepairBooks& books) const
{
  const int owner = this->OwnerOf(n, Fate::Given);
  Voxel v = this->PlaceOf(this->Changed[n]);
  while (this->IsInside(v) && this->LabelNow(Neighbour(v, 1)) == owner)
  {
    v = Neighbour(v, 1);
  }
  if (this->IsInside(v))
  {
    books.claims.push_back(ClaimAt(v, 1, owner, -1));
  }
}

void Bookkeeper::Book(Fate fate, RepairBooks& books) const
{
  const std::vector<std::size_t> nearest = this->NearestWithFaces(fate);
  for (std::size_t n = 0; n < nearest.size(); ++n)
  {
    const int owner = this->OwnerOf(n, fate);
    if (nearest[n] < nearest.size())
    {
      const std::vector<int> faces = this->FacesOf(nearest[n], fate);
      const Voxel v = this->PlaceOf(this->Changed[nearest[n]]);
      const double share = (fate == Fate::Taken ? 1.0 : -1.0) / static_cast<double>(faces.size());
      for (int d : faces)
      {
        books.claims.push_back(ClaimAt(v, d, owner, share));
      }
    }
    else if (fate == Fate::Given)
    {
      this->BookInside(n, books);
    }
    else if (owner != 0)
    {
      ++books.lostVoxels;
    }
  }
}

} // namespace

RepairBooks BookRepair(const LabelImage& first, const LabelImage& now, const std::vector<Id>& changed)
{
  RepairBooks books;
  const Bookkeeper keeper(first, now, changed);
  keeper.Book(Fate::Taken, books);
  keeper.Book(Fate::Given, books);
  return books;
}

} // namespace lamina
