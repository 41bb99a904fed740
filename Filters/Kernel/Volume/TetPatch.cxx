// SPDX-License-Identifier: BSD-3-Clause
#include "TetPatch.h"

#include "../Geometry/Predicates.h"
#include "../Mesh/TetFaces.h"

#include <algorithm>
#include <map>

namespace lamina
{
namespace
{

using Tet = std::array<Id, 4>;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

bool Has(const Tet& tet, const std::vector<Id>& part)
{
  return std::all_of(part.begin(), part.end(),
                     [&](Id p) { return std::find(tet.begin(), tet.end(), p) != tet.end(); });
}

/// Whether each face of these tets that has the part is between two of them, of one group.
bool IsInside(const TetSet& set, const std::vector<Id>& around, const std::vector<Id>& part)
{
  std::map<Triangle, int> seen;
  for (Id t : around)
  {
    const Tet& tet = set.tets[Index(t)];
    if (set.groups[Index(t)] != set.groups[Index(around.front())])
    {
      return false;
    }
    for (std::size_t k = 0; k < 4; ++k)
    {
      if (std::find(part.begin(), part.end(), tet[k]) == part.end())
      {
        Triangle face = TetFace(tet, k);
        std::sort(face.begin(), face.end());
        ++seen[face];
      }
    }
  }
  return std::all_of(seen.begin(), seen.end(), [](const auto& entry) { return entry.second == 2; });
}

} // namespace

bool SplitPart(TetSet& set, const std::vector<Id>& part)
{
  std::vector<Id> around;
  for (std::size_t t = 0; t < set.tets.size(); ++t)
  {
    around.insert(around.end(), Has(set.tets[t], part) ? 1 : 0, static_cast<Id>(t));
  }
  if (around.empty() || !IsInside(set, around, part))
  {
    return false;
  }
  Vec3 middle;
  for (Id p : part)
  {
    middle += (1.0 / static_cast<double>(part.size())) * set.points[Index(p)];
  }
  const Id added = static_cast<Id>(set.points.size());
  std::vector<Tet> halves;
  for (Id t : around)
  {
    for (Id p : part)
    {
      halves.push_back(set.tets[Index(t)]);
      std::replace(halves.back().begin(), halves.back().end(), p, added);
    }
  }
  set.points.push_back(middle);
  const auto at = [&](Id p) { return set.points[Index(p)]; };
  const auto isPositive = [&](const Tet& c)
  { return Orientation(at(c[0]), at(c[1]), at(c[2]), at(c[3])) > 0; };
  if (!std::all_of(halves.begin(), halves.end(), isPositive))
  {
    set.points.pop_back();
    return false;
  }
  set.fixed.push_back(0);
  if (!set.layerIndex.empty())
  {
    set.layerIndex.push_back(-1);
  }
  for (std::size_t i = 0; i < halves.size(); ++i)
  {
    const std::size_t from = Index(around[i / part.size()]);
    if (i % part.size() == 0)
    {
      set.tets[from] = halves[i];
      continue;
    }
    set.tets.push_back(halves[i]);
    set.groups.push_back(set.groups[from]);
  }
  return true;
}

TetPatches::TetPatches(TetSet& set)
  : Set(set)
  , Start(set.points.size() + 1, 0)
  , IsTaken(set.tets.size(), 0)
  , Local(set.points.size(), -1)
{
  for (const Tet& tet : set.tets)
  {
    for (Id p : tet)
    {
      ++this->Start[Index(p) + 1];
    }
  }
  for (std::size_t p = 1; p < this->Start.size(); ++p)
  {
    this->Start[p] += this->Start[p - 1];
  }
  this->Stars.resize(4 * set.tets.size());
  std::vector<std::size_t> next(this->Start.begin(), this->Start.end() - 1);
  for (std::size_t t = 0; t < set.tets.size(); ++t)
  {
    for (Id p : set.tets[t])
    {
      this->Stars[next[Index(p)]++] = static_cast<Id>(t);
    }
  }
}

bool TetPatches::Grow(Id tet, int rings)
{
  for (Id t : this->Tets)
  {
    this->IsTaken[Index(t)] = 0;
  }
  this->Tets.assign(1, tet);
  this->IsTaken[Index(tet)] = 1;
  std::size_t from = 0;
  for (int ring = 0; ring < rings; ++ring)
  {
    const std::size_t to = this->Tets.size();
    for (; from < to; ++from)
    {
      const Tet corners = this->Set.tets[Index(this->Tets[from])];
      if (corners[0] < 0)
      {
        return false;
      }
      for (Id p : corners)
      {
        for (std::size_t i = this->Start[Index(p)]; i < this->Start[Index(p) + 1]; ++i)
        {
          const Id t = this->Stars[i];
          if (this->IsTaken[Index(t)] == 0)
          {
            this->IsTaken[Index(t)] = 1;
            this->Tets.push_back(t);
          }
        }
      }
    }
  }
  return std::all_of(this->Tets.begin(), this->Tets.end(),
                     [&](Id t) { return this->Set.tets[Index(t)][0] >= 0; });
}

void TetPatches::Number()
{
  for (Id p : this->Points)
  {
    this->Local[Index(p)] = -1;
  }
  this->Points.clear();
  for (Id t : this->Tets)
  {
    for (Id p : this->Set.tets[Index(t)])
    {
      if (this->Local[Index(p)] < 0)
      {
        this->Local[Index(p)] = static_cast<Id>(this->Points.size());
        this->Points.push_back(p);
      }
    }
  }
}

bool TetPatches::Take(Id tet, int rings, TetSet& patch, Tet& own)
{
  if (!this->Grow(tet, rings))
  {
    return false;
  }
  this->Number();
  patch = TetSet{};
  for (Id p : this->Points)
  {
    const auto first = this->Stars.begin() + static_cast<std::ptrdiff_t>(this->Start[Index(p)]);
    const auto last = this->Stars.begin() + static_cast<std::ptrdiff_t>(this->Start[Index(p) + 1]);
    const bool isShared = std::any_of(first, last, [&](Id t) { return this->IsTaken[Index(t)] == 0; });
    patch.points.push_back(this->Set.points[Index(p)]);
    patch.fixed.push_back(isShared ? 1 : this->Set.fixed[Index(p)]);
    if (!this->Set.layerIndex.empty())
    {
      patch.layerIndex.push_back(this->Set.layerIndex[Index(p)]);
    }
  }
  const auto numbered = [&](Tet corners)
  {
    std::transform(corners.begin(), corners.end(), corners.begin(),
                   [&](Id p) { return this->Local[Index(p)]; });
    return corners;
  };
  for (Id t : this->Tets)
  {
    patch.tets.push_back(numbered(this->Set.tets[Index(t)]));
    patch.groups.push_back(this->Set.groups[Index(t)]);
  }
  own = numbered(this->Set.tets[Index(tet)]);
  return true;
}

void TetPatches::PutBack(const TetSet& patch)
{
  const std::size_t known = this->Points.size();
  for (std::size_t p = 0; p < patch.points.size(); ++p)
  {
    if (p >= known)
    {
      this->Points.push_back(static_cast<Id>(this->Set.points.size()));
      this->Set.points.emplace_back();
      this->Set.fixed.push_back(0);
      this->Set.layerIndex.resize(this->Set.layerIndex.empty() ? 0 : this->Set.points.size());
      this->Local.push_back(-1);
    }
    this->Set.points[Index(this->Points[p])] = patch.points[p];
    if (!this->Set.layerIndex.empty())
    {
      this->Set.layerIndex[Index(this->Points[p])] = patch.layerIndex[p];
    }
  }
  for (Id t : this->Tets)
  {
    this->Set.tets[Index(t)][0] = -1;
  }
  for (std::size_t t = 0; t < patch.tets.size(); ++t)
  {
    Tet tet = patch.tets[t];
    std::transform(tet.begin(), tet.end(), tet.begin(), [&](Id p) { return this->Points[Index(p)]; });
    this->Set.tets.push_back(tet);
    this->Set.groups.push_back(patch.groups[t]);
  }
}

} // namespace lamina
