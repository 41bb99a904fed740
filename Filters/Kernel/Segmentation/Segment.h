// SPDX-License-Identifier: BSD-3-Clause
// From grey values to material ids: thresholds, disputed voxels, walls between blood and background, islands.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/LabelImage.h"

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

struct SegmentOptions
{
  /// Grey values, ascending. Three: background, tissue, disputed, blood; two: background, tissue, blood; any
  /// other number: one material per class, numbered from 0, of which none is disputed and none needs a wall.
  std::vector<double> thresholds{ 50, 110, 150 };
  /// A disputed voxel with at least this many tissue voxels among its 26 neighbours is a thin vessel:
  /// blood. 1..27.
  int coronaryMajority = 14;
  /// Keep every component above the sizes below, or the largest of each material alone.
  bool largestOnly = false;
  /// Components smaller than this share of their material (0..1), or than this many voxels, go to a
  /// neighbour.
  double minimumShare = 0.001;
  Id minimumVoxels = 50;
  /// Blood may reach the image's border, or the mask's edge, without tissue made over it.
  bool openAtImageBorder = false;
  bool openAtMaskBorder = false;
  /// Region of interest: where it is not 1 the material is 0. Same size as the grey image; may be null.
  const LabelImage* mask = nullptr;
};

/// What one rule did: voxels, and components where it deals with them, that ended up in `material`.
struct SegmentRule
{
  std::string name;
  int material = 0;
  Id components = 0;
  Id voxels = 0;
};

struct SegmentMaterial
{
  int id = 0;
  Id voxels = 0;
  Id components = 0; ///< over faces
};

struct SegmentReport
{
  std::vector<SegmentRule> rules; ///< in the order of work
  std::vector<SegmentMaterial> materials;
  double least = 0; ///< range of the finite grey values
  double greatest = 0;
  Id disputed = 0; ///< voxels flagged
  int passes = 0;  ///< of walls and islands, until nothing changed
  std::vector<std::string> warnings;
};

/// Segment `grey` into `labels`; `disputed` (one flag a voxel) marks the voxels whose material was a guess.
/// NaN is background. Blood has a wall of at least one tissue voxel against background, openings apart.
Result<SegmentReport> Segment(const GreyImage& grey, LabelImage& labels, std::vector<unsigned char>& disputed,
                              const SegmentOptions& options, Monitor& monitor);

} // namespace lamina
