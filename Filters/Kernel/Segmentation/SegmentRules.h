// SPDX-License-Identifier: BSD-3-Clause
// The rules of segmentation, one call each. They share a label image in which two ids below 0 have a meaning.
#pragma once

#include "ConnectedComponents.h"
#include "Segment.h"

namespace lamina
{
namespace segment
{

/// Outside the region of interest: becomes background at the end, and no rule may change it.
constexpr int Outside = -1;
/// Between the thresholds of tissue and blood.
constexpr int Undecided = -2;

/// What the rules work on.
struct Work
{
  const GreyImage& grey;
  const SegmentOptions& options;
  std::vector<int>& labels;
  std::vector<unsigned char>& disputed;
  SegmentReport& report;

  const std::array<Id, 3>& Size() const { return this->grey.grid.size; }
  Id Count() const { return static_cast<Id>(this->labels.size()); }
  /// True if blood and tissue have their meaning: two or three thresholds.
  bool HasBlood() const
  {
    return this->options.thresholds.size() == 2 || this->options.thresholds.size() == 3;
  }
  void Note(const char* rule, int material, Id components, Id voxels);
};

/// Call visit(neighbour) for each voxel of the 26 around `voxel` that lies in the image.
template<typename Visit>
void ForEachNeighbour26(const std::array<Id, 3>& size, Id voxel, const Visit& visit)
{
  const Id i = voxel % size[0];
  const Id j = (voxel / size[0]) % size[1];
  const Id k = voxel / (size[0] * size[1]);
  for (Id c = (k > 0 ? k - 1 : k); c <= (k + 1 < size[2] ? k + 1 : k); ++c)
  {
    for (Id b = (j > 0 ? j - 1 : j); b <= (j + 1 < size[1] ? j + 1 : j); ++b)
    {
      for (Id a = (i > 0 ? i - 1 : i); a <= (i + 1 < size[0] ? i + 1 : i); ++a)
      {
        if (a != i || b != j || c != k)
        {
          visit(a + size[0] * (b + size[1] * c));
        }
      }
    }
  }
}

inline bool IsAtBorder(const std::array<Id, 3>& size, Id voxel)
{
  const Id i = voxel % size[0];
  const Id j = (voxel / size[0]) % size[1];
  const Id k = voxel / (size[0] * size[1]);
  return i == 0 || j == 0 || k == 0 || i == size[0] - 1 || j == size[1] - 1 || k == size[2] - 1;
}

/// Thresholds and mask to classes.
void Classify(Work& work, Monitor& monitor);
/// Undecided voxels: enclosed groups, thin vessels, then the likelier material.
void ResolveUndecided(Work& work, Monitor& monitor);
/// Background that touches blood becomes tissue; blood at a closed border becomes tissue. Returns the voxels
/// changed.
Id BuildWalls(Work& work, Monitor& monitor);

/// The size below which a component of each material goes to a neighbour, fixed before the first pass.
struct IslandLimits
{
  std::vector<Id> least; ///< indexed by material
};
IslandLimits MakeIslandLimits(const Work& work);
/// Give small components to the neighbours with most faces in common. Returns the voxels changed.
Id RemoveIslands(Work& work, const IslandLimits& limits, Monitor& monitor);

} // namespace segment
} // namespace lamina
