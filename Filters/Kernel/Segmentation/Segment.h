// SPDX-License-Identifier: BSD-3-Clause
// From grey values to material ids: thresholds, disputed voxels, skins, walls between blood and background,
// islands, repair of the topology.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/GreyView.h"
#include "BettiNumbers.h"

#include <string>
#include <vector>

namespace lamina
{

/// The material ids that two or three thresholds make.
enum Material : int
{
  Background = 0,
  Tissue = 1,
  Blood = 2
};

/// What becomes of the disputed voxels that the rules for groups and for thin vessels leave.
enum class DisputedChoice
{
  Likelier = 0, ///< the likelier material by grey value and neighbours: a random walker
  Person = 1    ///< the material of the nearest mean, until a person decides
};

/// Which components of a material stay, of those that are large enough.
enum class KeptComponents
{
  All = 0,
  Largest = 1,    ///< the largest alone
  LargestFew = 2, ///< the `keptCount` largest
};

/// What is done about materials that meet themselves, or a forbidden material, in an edge or a corner only.
enum class TopologyRepair
{
  Repair = 0,
  FlagOnly = 1,
  Off = 2
};

/// Bits of the flags beside the labels.
enum SegmentFlag : unsigned char
{
  FlagDisputed = 1, ///< the material was a guess
  FlagFault = 2,    ///< stands in a topological fault that was left
  FlagRepaired = 4  ///< changed by the repair of the topology
};

struct SegmentOptions
{
  /// Grey values, ascending. Three: background, tissue, disputed, blood; two: background, tissue, blood; any
  /// other number: one material per class, numbered from 0, of which none is disputed and none needs a wall.
  /// None, the default of the filter: by the image, see ModeThresholds. These suit the phantom.
  std::vector<double> thresholds{ 50, 110, 150 };
  /// Sweeps of edge-preserving smoothing before the thresholds, 0 (off) to 20. An image without noise stays
  /// as it is.
  int smoothingSweeps = 2;
  /// A disputed voxel with at least this many tissue voxels among its 26 neighbours is a thin vessel:
  /// blood, unless a chamber ends there. 1..27.
  int coronaryMajority = 14;
  DisputedChoice disputed = DisputedChoice::Likelier;
  /// Whether shells that partial volume draws between two materials are given to the two.
  bool dissolveSkins = true;
  KeptComponents kept = KeptComponents::All;
  /// At least 1; counts for KeptComponents::LargestFew.
  Id keptCount = 1;
  /// Components smaller than this share of their material (0..1), or than this many voxels, go to a
  /// neighbour.
  double minimumShare = 0.001;
  Id minimumVoxels = 50;
  /// Pairs of materials that may not touch over faces, edges or corners. The pair background and blood as it
  /// stands here counts for two and three thresholds only; tissue is built between them.
  std::vector<std::array<int, 2>> forbidden{ { { Background, Blood } } };
  TopologyRepair repair = TopologyRepair::Repair;
  /// Blood may reach the image's border, or the mask's edge, without tissue made over it.
  bool openAtImageBorder = false;
  bool openAtMaskBorder = false;
  /// Region of interest: outside, the material is 0. Same size as the grey image; may be null.
  const RegionMask* mask = nullptr;
};

/// What one rule did: voxels, and components where it deals with them, that ended up in `material`.
struct SegmentRule
{
  std::string name;
  int material = 0;
  Id components = 0;
  Id voxels = 0;
};

/// Topological faults: those found before each repair, and what is left.
struct SegmentTopology
{
  Id criticalEdges = 0;
  Id criticalCorners = 0;
  Id forbiddenContacts = 0;
  Id changed = 0; ///< voxels, by the repair
  Id remaining = 0;
};

struct SegmentReport
{
  std::vector<SegmentRule> rules; ///< in the order of work
  /// Of each material right after the thresholds, where disputed voxels count to the material of the nearest
  /// mean, and in the end.
  std::vector<BettiNumbers> before;
  std::vector<BettiNumbers> after;
  SegmentTopology topology;
  double least = 0; ///< range of the finite grey values
  double greatest = 0;
  std::vector<double> thresholds; ///< those of the options or of the histogram
  std::vector<double> modes;      ///< grey values that fill places, where thresholds came from them
  double noise = 0;               ///< estimated deviation; 0 where the image has none
  Id disputed = 0;                ///< voxels flagged
  int passes = 0;                 ///< of walls, islands and repair, until nothing changed
  std::vector<std::string> warnings;
};

/// Segment `grey` into `labels`; `flags` (one a voxel, of SegmentFlag) tells which voxels to look at. NaN is
/// background. Afterwards no forbidden pair touches and no material meets itself in an edge or a corner only,
/// openings apart, if the repair is on. The same for any number of threads.
Result<SegmentReport> Segment(const GreyView& grey, LabelImage& labels, std::vector<unsigned char>& flags,
                              const SegmentOptions& options, Monitor& monitor);

} // namespace lamina
