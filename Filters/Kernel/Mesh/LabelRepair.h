// SPDX-License-Identifier: BSD-3-Clause
// The order in which faulty places of a label image are mended.
#pragma once

#include "../Base/Monitor.h"
#include "LabelLattice.h"
#include "MaterialContacts.h"
#include "RepairSearch.h"
#include "WellComposed.h"

#include <map>

namespace lamina
{

/// Groups of faulty places that lie together are searched as one if they are few; where they are many
/// (noise), the changes that mend most go first, then what is left is mended place by place, and at the end
/// changes that turn out needless are taken back. See RepairTopology for what holds.
class LabelRepair
{
public:
  using Place = LabelLattice::Place;

  LabelRepair(LabelImage& image, const RepairOptions& options, const LabelLattice& lattice,
              const MaterialContacts& known, PointFlags faulty);

  /// Mend all faulty places; returns the number of those that stay faulty.
  Id Run(Monitor& monitor);
  /// Voxels whose label differs from the first, ascending.
  std::vector<Id> Changed() const;

private:
  /// Larger groups (noise) are mended part by part, so that time and memory stay in proportion.
  static constexpr std::size_t MostInPart = 8192;
  static constexpr Id StepsInNoise = 40;

  /// How much a change may break.
  struct Care
  {
    RepairPrices prices;
    double dearest;
    Id steps; ///< of a search for one place
  };

  bool IsFaulty(const Place& point) const { return this->Faulty.At(point); }
  int& LabelOf(const Place& v)
  {
    return this->Image.labels[static_cast<std::size_t>(this->Lattice.VoxelIndex(v))];
  }
  std::vector<Place> FaultyNear(const Place& centre, Id distance, std::size_t most) const;
  bool HasFaultyCorner(const Place& voxel) const;
  void Set(const Place& voxel, int label);
  void NoteRough(const Place& voxel);
  bool Apply(const std::vector<LabelChange>& changes);

  void RankLabels(const RepairOptions& options);
  void MendGroups(Monitor& monitor);
  std::vector<Place> GroupFrom(const Place& start, PointFlags& grouped) const;
  void MendGroup(const std::vector<Place>& group, Monitor& monitor);
  std::vector<LabelChange> TakeBackFrom(std::size_t begin);
  bool MendPlaces(const std::vector<Place>& group, std::size_t begin, const Care& care, Monitor& monitor);
  bool MendCarefully(const std::vector<Place>& group, Monitor& monitor);
  void MendGreedily(const std::vector<Place>& group, const Care& care, Monitor& monitor);
  void MendFrom(const Place& start, Monitor& monitor);
  void MendOneByOne(Monitor& monitor);
  class Promises;
  void Consider(const Place& voxel, const Care& care, Promises& promises);
  bool MendByOne(const Place& point, const Care& care);
  bool MendPlace(const Place& point, const Care& care);
  bool Climb(const Place& point);
  LabelChange BestChange(const Place& voxel, const Care& care, double& score);
  bool TakeBackAt(Id voxel);
  void TakeBack(Monitor& monitor);
  void Improve(Monitor& monitor);
  bool ImproveAround(const Place& voxel);

  LabelImage& Image;
  FirstLabels First; ///< bodies are told from fragments in the image as it came
  const LabelLattice& Lattice;
  const MaterialContacts& Known;
  PointFlags Faulty;
  RepairCost Cost;
  RepairSearch Search;
  std::map<int, int> Rank;      ///< of labels: climbing goes up
  int Top = 0;                  ///< the label of highest rank
  std::vector<LabelChange> Log; ///< the changes to the group in work
  double Spent = 0;             ///< what the changes of searches cost at careful prices
  std::vector<Id> Rough;        ///< voxels changed without a complete search, some of them
  Id PlaceSteps = 0;            ///< left for MendPlace()
  Id Steps = 0;                 ///< left for Improve()
};

} // namespace lamina
