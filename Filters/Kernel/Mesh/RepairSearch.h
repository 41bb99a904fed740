// SPDX-License-Identifier: BSD-3-Clause
// The cheapest changes of labels that mend a few lattice points.
#pragma once

#include "PointFlags.h"
#include "RepairCost.h"

namespace lamina
{

/// Branch and bound over changes: some voxel of a faulty block must change.
class RepairSearch
{
public:
  using Place = LabelLattice::Place;

  struct Limits
  {
    double cost = 0;        ///< solutions must be cheaper
    Id steps = 0;           ///< changes tried at most
    RepairPrices prices;    ///< of single changes
    double dearest = 1e300; ///< no single change may cost more
  };

  /// labels: those that the lattice sees; first: as they came. All outlive the search.
  RepairSearch(std::vector<int>& labels, FirstLabels& first, const LabelLattice& lattice, RepairCost& cost,
               const PointFlags& faulty)
    : Labels(labels)
    , First(first)
    , Lattice(lattice)
    , Cost(cost)
    , Faulty(faulty)
  {
  }

  /// The cheapest changes found after which none of `points` has a fault, nor any lattice point that had none
  /// before. Empty if there are none within the limits. The labels are as before when it returns.
  std::vector<LabelChange> Find(const std::vector<Place>& points, const Limits& limits);
  /// What the changes that the last Find() returned cost.
  Id StepsTaken() const { return this->Steps; }
  double BestCostFound() const { return this->BestCost; }

private:
  struct Option
  {
    LabelChange change;
    double cost = 0;
    int faults = 0; ///< after less before
  };

  void Search(double cost);
  /// Faulty points that matter now; the least number of changes that they need.
  int Remaining(Place& first) const;
  std::vector<Option> OptionsAt(const Place& point);
  bool IsExcluded(const LabelChange& change) const;
  int& LabelOf(const Place& v) { return this->Labels[static_cast<std::size_t>(this->Lattice.VoxelIndex(v))]; }
  void Watch(const Place& voxel);

  std::vector<int>& Labels;
  FirstLabels& First;
  const LabelLattice& Lattice;
  RepairCost& Cost;
  const PointFlags& Faulty;
  std::vector<Place> Goal;
  std::vector<Place> Watched; ///< the goal, and the corners of the voxels changed
  std::vector<LabelChange> Path;
  std::vector<LabelChange> Excluded;
  std::vector<LabelChange> Best;
  double BestCost = 0;
  Id Steps = 0;
  Limits Now;
};

} // namespace lamina
