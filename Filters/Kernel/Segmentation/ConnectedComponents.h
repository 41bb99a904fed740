// SPDX-License-Identifier: BSD-3-Clause
// Connected components of a label image, found over runs of equal labels along i (linear time, small memory).
#pragma once

#include "../Base/Monitor.h"

#include <array>
#include <vector>

namespace lamina
{

/// Voxels that count as neighbours: over faces, or over faces, edges and corners.
enum class Connectivity
{
  Faces = 6,
  Corners = 26
};

/// A row's stretch of voxels [begin, end) of one label, and the component it belongs to.
struct LabelRun
{
  int begin = 0;
  int end = 0;
  int label = 0;
  int component = 0;
};

/// One connected component: its label, its size and its first voxel in memory order.
struct Component
{
  int label = 0;
  Id voxels = 0;
  Id firstVoxel = 0;
};

/// The components of a label image, numbered by their first voxel: the same for any number of threads.
struct ComponentMap
{
  std::array<Id, 3> size{ { 0, 0, 0 } };
  std::vector<Id> rowStart; ///< runs of row r = j + size[1] * k are [rowStart[r], rowStart[r + 1])
  std::vector<LabelRun> runs;
  std::vector<Component> components;

  /// The number of components that carry `label`.
  Id CountOf(int label) const;
};

/// The most voxels of an image whose components can be found: runs and components are counted by int, as
/// their memory is most of what the search takes.
constexpr Id MostVoxelsOfComponents = 2147483647;

/// Find the components of every label in `labels` (i runs fastest). Takes 16 bytes a run, no memory a voxel.
ComponentMap FindComponents(const std::vector<int>& labels, const std::array<Id, 3>& size,
                            Connectivity connectivity, Monitor& monitor);

} // namespace lamina
