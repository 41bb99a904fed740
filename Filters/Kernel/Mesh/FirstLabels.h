// SPDX-License-Identifier: BSD-3-Clause
// The labels of an image as it came, while it is changed.
#pragma once

#include "../Base/Types.h"

#include <array>
#include <memory>
#include <vector>

namespace lamina
{

/// Keeps what changes only: the voxels in runs of 64, each copied before its first change.
class FirstLabels
{
public:
  /// labels: outlives this; a voxel of it may change only after Keep().
  explicit FirstLabels(const std::vector<int>& labels)
    : Labels(labels)
    , Runs((labels.size() + RunLength - 1) / RunLength)
  {
  }

  int Of(Id voxel) const
  {
    const std::size_t v = static_cast<std::size_t>(voxel);
    const Run* run = this->Runs[v / RunLength].get();
    return run ? run->labels[v % RunLength] : this->Labels[v];
  }
  bool IsChanged(Id voxel) const { return this->Of(voxel) != this->Labels[static_cast<std::size_t>(voxel)]; }
  void Keep(Id voxel) { this->RunOf(voxel); }
  /// How often searches changed a voxel.
  unsigned char& Searched(Id voxel)
  {
    return this->RunOf(voxel).searched[static_cast<std::size_t>(voxel) % RunLength];
  }
  /// Call visit(voxel) for each that differs from what it was, ascending. It may change voxels.
  template<typename Visit>
  void ForEachChanged(const Visit& visit) const
  {
    for (std::size_t r = 0; r < this->Runs.size(); ++r)
    {
      const std::size_t first = r * RunLength;
      for (std::size_t n = 0; this->Runs[r] && n < RunLength && first + n < this->Labels.size(); ++n)
      {
        if (this->Runs[r]->labels[n] != this->Labels[first + n])
        {
          visit(static_cast<Id>(first + n));
        }
      }
    }
  }

private:
  static constexpr std::size_t RunLength = 64;
  struct Run
  {
    std::array<int, RunLength> labels{};
    std::array<unsigned char, RunLength> searched{};
  };
  Run& RunOf(Id voxel)
  {
    const std::size_t r = static_cast<std::size_t>(voxel) / RunLength;
    if (!this->Runs[r])
    {
      this->Runs[r] = std::make_unique<Run>();
      for (std::size_t n = 0; n < RunLength && r * RunLength + n < this->Labels.size(); ++n)
      {
        this->Runs[r]->labels[n] = this->Labels[r * RunLength + n];
      }
    }
    return *this->Runs[r];
  }

  const std::vector<int>& Labels;
  std::vector<std::unique_ptr<Run>> Runs;
};

} // namespace lamina
