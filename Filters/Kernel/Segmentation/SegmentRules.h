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
/// A flag of the work only: a rule decided on this voxel, not its own grey value.
constexpr unsigned char MadeByRule = 128;

/// Mean and standard deviation of the grey values of one class; count 0 where it has none.
struct ClassValues
{
  double mean = 0;
  double deviation = 0;
  Id count = 0;
};

/// What the rules work on.
struct Work
{
  GreyView grey; ///< smoothed; empty once all voxels are decided
  const SegmentOptions& options;
  LabelImage& image;
  std::vector<int>& labels; ///< those of `image`
  std::vector<unsigned char>& flags;
  SegmentReport& report;
  std::vector<ClassValues> classes; ///< by material, of the voxels inside it
  std::vector<Id> voxels;           ///< by material, as last counted

  const std::array<Id, 3>& Size() const { return this->image.grid.size; }
  Id Count() const { return static_cast<Id>(this->labels.size()); }
  bool HasDisputed() const { return this->options.thresholds.size() == 3; }
  int Materials() const
  {
    return this->HasDisputed() ? 3 : static_cast<int>(this->options.thresholds.size()) + 1;
  }
  /// True if walls of tissue stand between blood and background.
  bool HasWalls() const;
  /// True if the two materials may not touch.
  bool IsForbidden(int first, int second) const;
  /// The forbidden pairs that count for this number of thresholds.
  std::vector<std::array<int, 2>> Forbidden() const;
  void Note(const char* rule, int material, Id components, Id voxels);
  /// Count the voxels of each material, and warn of those that the rule just done with took the last of.
  void Recount(const char* rule, Monitor& monitor);
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

/// What cannot be segmented, before any work. The image's range goes into the report.
Result<bool> Check(const GreyView& grey, SegmentOptions& options, SegmentReport& report, Monitor& monitor);
/// The deviation of the noise, from second differences inside the classes: the least of those that have any.
double EstimateNoise(const GreyView& grey, const SegmentOptions& options, const SegmentReport& report);
/// Thresholds by the modes of the smoothed image, which go into the report; N. Otsu's two where fewer than
/// two modes are found. None if cancelled.
std::vector<double> SuggestThresholds(const GreyView& grey, SegmentReport& report, Monitor& monitor);
/// The image without its noise, in memory of its own; the same view where there is no noise or no smoothing.
GreyView Smoothed(const GreyView& grey, const SegmentOptions& options, SegmentReport& report,
                  Monitor& monitor);
/// Thresholds and mask to classes.
void Classify(Work& work, Monitor& monitor);
/// The grey values of each class, away from its borders.
void MeasureClasses(Work& work, Monitor& monitor);
/// Undecided voxels: enclosed groups, thin vessels, then the likelier material, or the nearest class.
void ResolveUndecided(Work& work, Monitor& monitor);
/// The share of blood, 0 to 1, in each of `voxels` (undecided, ascending) by a random walk from the decided
/// voxels around them.
std::vector<double> WalkToBlood(const Work& work, const std::vector<Id>& voxels, Monitor& monitor);
/// Voxels of a shell between two materials go to the nearer of the two.
void DissolveSkins(Work& work, Monitor& monitor);
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

/// The mask without voxels across which it, or what is outside it, touches itself over an edge or a corner
/// only. Where blood is open to the outside, a repair at such a place could only make background, which blood
/// may not touch.
RegionMask TrimMask(const RegionMask& mask, Monitor& monitor);
/// Repair the topology. Returns the voxels changed.
Id Repair(Work& work, Monitor& monitor);
/// Flag the voxels that stand in a fault.
void FlagFaults(Work& work, Monitor& monitor);
/// Betti numbers of the materials as they are, undecided voxels by the nearest mean.
std::vector<BettiNumbers> CountBetti(Work& work, Monitor& monitor);

} // namespace segment
} // namespace lamina
