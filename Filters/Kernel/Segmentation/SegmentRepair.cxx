// SPDX-License-Identifier: BSD-3-Clause
// The repair of the topology inside the rules, and the counts that tell what it was like.
#include "SegmentRules.h"

#include "../Mesh/WellComposed.h"

#include <algorithm>

namespace lamina
{
namespace segment
{

namespace
{

/// While it lives, the voxels outside the mask are background, which may not change.
class FrozenOutside
{
public:
  FrozenOutside(Work& work, Monitor& monitor)
    : Image(work)
    , Threads(monitor)
  {
    if (!work.options.mask)
    {
      return;
    }
    this->Frozen.resize(work.labels.size());
    monitor.For(work.Count(), 65536,
                [&](Id begin, Id end)
                {
                  for (Id v = begin; v < end; ++v)
                  {
                    this->Frozen[v] = this->Image.labels[v] == Outside;
                    this->Image.labels[v] = std::max(this->Image.labels[v], 0);
                  }
                });
  }
  ~FrozenOutside()
  {
    for (std::size_t v = 0; v < this->Frozen.size(); ++v)
    {
      this->Image.labels[v] = this->Frozen[v] ? int{ Outside } : this->Image.labels[v];
    }
  }
  FrozenOutside(const FrozenOutside&) = delete;
  FrozenOutside& operator=(const FrozenOutside&) = delete;

  RepairOptions Options() const
  {
    RepairOptions options;
    for (const auto& pair : this->Image.Forbidden())
    {
      options.forbidden.push_back({ pair[0], pair[1] });
    }
    options.openAtImageBorder = this->Image.options.openAtImageBorder;
    options.openAtFrozen = this->Image.options.openAtMaskBorder;
    options.frozen = this->Frozen.empty() ? nullptr : &this->Frozen;
    return options;
  }

private:
  Work& Image;
  Monitor& Threads;
  std::vector<unsigned char> Frozen;
};

} // namespace

RegionMask TrimMask(const RegionMask& mask, Monitor& monitor)
{
  LabelImage region{ mask.grid, std::vector<int>(mask.inside.size()) };
  std::vector<unsigned char> outside(mask.inside.size());
  for (std::size_t v = 0; v < outside.size(); ++v)
  {
    region.labels[v] = mask.inside[v] != 0 ? 1 : 0;
    outside[v] = mask.inside[v] == 0;
  }
  RepairOptions options;
  options.frozen = &outside;
  RepairTopology(region, options, monitor);
  return { mask.grid, { region.labels.begin(), region.labels.end() } };
}

Id Repair(Work& work, Monitor& monitor)
{
  if (work.options.repair != TopologyRepair::Repair)
  {
    return 0;
  }
  const FrozenOutside frozen(work, monitor);
  const RepairReport report = RepairTopology(work.image, frozen.Options(), monitor);
  SegmentTopology& topology = work.report.topology;
  topology.criticalEdges += report.criticalEdges;
  topology.criticalCorners += report.criticalCorners;
  topology.forbiddenContacts += report.forbiddenContacts;
  topology.changed += static_cast<Id>(report.changed.size());
  topology.remaining = report.remaining;
  std::vector<Id> changed(work.Materials(), 0);
  for (const Id v : report.changed)
  {
    work.flags[v] |= FlagRepaired;
    ++changed[work.labels[v]];
  }
  for (std::size_t m = 0; m < changed.size(); ++m)
  {
    if (changed[m] > 0)
    {
      work.Note("topology repaired", static_cast<int>(m), 0, changed[m]);
    }
  }
  return static_cast<Id>(report.changed.size());
}

void FlagFaults(Work& work, Monitor& monitor)
{
  const bool left = work.options.repair == TopologyRepair::Repair && work.report.topology.remaining > 0;
  if (work.options.repair != TopologyRepair::FlagOnly && !left)
  {
    return;
  }
  const FrozenOutside frozen(work, monitor);
  const std::vector<Id> faults = FindTopologyFaults(work.image, frozen.Options(), monitor);
  for (const Id v : faults)
  {
    work.flags[v] |= FlagFault;
  }
  work.Note("topological fault, flagged", 0, 0, static_cast<Id>(faults.size()));
}

std::vector<BettiNumbers> CountBetti(Work& work, Monitor& monitor)
{
  const double middle = work.HasDisputed() ? 0.5 * (work.classes[Tissue].mean + work.classes[Blood].mean) : 0;
  monitor.For(work.Count(), 65536,
              [&](Id begin, Id end)
              {
                for (Id v = begin; v < end; ++v)
                {
                  int& label = work.labels[v];
                  if (label == Undecided)
                  {
                    label = work.grey.At(v) > middle ? Blood : Tissue;
                  }
                  label = std::max(label, 0);
                }
              });
  return CountBettiNumbers(work.image, monitor);
}

} // namespace segment
} // namespace lamina
