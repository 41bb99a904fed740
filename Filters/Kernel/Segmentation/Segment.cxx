// SPDX-License-Identifier: BSD-3-Clause
#include "Segment.h"
#include "SegmentRules.h"

#include <algorithm>
#include <mutex>
#include <sstream>

namespace lamina
{

namespace segment
{

namespace
{

using Pairs = std::vector<std::array<int, 2>>;

/// The pair that comes with the options, as it stands there.
bool IsDefault(const Pairs& forbidden)
{
  return forbidden.size() == 1 && forbidden[0] == std::array<int, 2>{ { Background, Blood } };
}

} // namespace

Pairs Work::Forbidden() const
{
  const bool named = this->Materials() == 3;
  return !named && IsDefault(this->options.forbidden) ? Pairs{} : this->options.forbidden;
}

bool Work::IsForbidden(int first, int second) const
{
  const Pairs& pairs = this->options.forbidden;
  const bool named = this->Materials() == 3;
  const auto is = [&](const std::array<int, 2>& pair)
  { return (pair[0] == first && pair[1] == second) || (pair[0] == second && pair[1] == first); };
  return (named || !IsDefault(pairs)) && std::any_of(pairs.begin(), pairs.end(), is);
}

bool Work::HasWalls() const
{
  return this->Materials() == 3 && this->IsForbidden(Background, Blood);
}

void Work::Note(const char* rule, int material, Id components, Id count)
{
  auto& rules = this->report.rules;
  const auto same =
    std::find_if(rules.begin(), rules.end(),
                 [&](const SegmentRule& known) { return known.name == rule && known.material == material; });
  if (same == rules.end())
  {
    rules.push_back({ rule, material, components, count });
    return;
  }
  same->components += components;
  same->voxels += count;
}

void Work::Recount(const char* rule, Monitor& monitor)
{
  std::vector<Id> counts(static_cast<std::size_t>(this->Materials()), 0);
  std::mutex guard;
  monitor.For(this->Count(), 1 << 18,
              [&](Id begin, Id end)
              {
                std::vector<Id> own(counts.size(), 0);
                for (Id v = begin; v < end; ++v)
                {
                  if (this->labels[v] >= 0)
                  {
                    ++own[this->labels[v]];
                  }
                }
                const std::lock_guard<std::mutex> lock(guard);
                std::transform(own.begin(), own.end(), counts.begin(), counts.begin(), std::plus<Id>());
              });
  for (std::size_t m = 0; m < counts.size() && !monitor.Cancelled(); ++m)
  {
    if (!this->voxels.empty() && this->voxels[m] > 0 && counts[m] == 0)
    {
      std::ostringstream text;
      text << "material " << m << " vanished: its last " << this->voxels[m] << " voxels went by the rule \""
           << rule << "\"";
      this->report.warnings.push_back(text.str());
    }
  }
  this->voxels = counts;
}

} // namespace segment

namespace
{

using segment::Work;

void NoteClasses(Work& work)
{
  for (int m = 0; m < work.Materials(); ++m)
  {
    if (work.voxels[m] == 0)
    {
      work.report.warnings.push_back(
        "material " + std::to_string(m) +
        " has no voxel between its thresholds, after smoothing and inside the mask");
    }
  }
  Id inside = 0;
  for (int m = 0; m < work.Materials(); ++m)
  {
    inside += work.voxels[m];
  }
  if (work.options.mask)
  {
    const auto& mask = work.options.mask->inside;
    work.Note("outside the mask", Background, 0, std::count(mask.begin(), mask.end(), 0));
  }
  for (int m = 0; m < work.Materials(); ++m)
  {
    work.Note("thresholds", m, 0, work.voxels[m]);
  }
}

/// Walls, islands and repair undo each other's work at places: repeat until none changes a voxel. The last
/// word is the repair's, which makes no new fault.
void CleanUp(Work& work, Monitor& monitor)
{
  constexpr int mostPasses = 50;
  const auto share = [](int halfPasses) { return 0.3 + 0.6 * halfPasses / (halfPasses + 2); };
  const segment::IslandLimits limits = segment::MakeIslandLimits(work);
  for (int pass = 1; pass <= mostPasses && !monitor.Cancelled(); ++pass)
  {
    work.report.passes = pass;
    monitor.Progress(share(2 * pass - 2), "building walls, removing islands");
    const Id walls = segment::BuildWalls(work, monitor);
    if (walls > 0)
    {
      work.Recount("background that touches blood", monitor);
    }
    // An island inside an island has its turn once the outer one is gone, before walls are built around
    // either.
    Id islands = 0;
    for (Id more = segment::RemoveIslands(work, limits, monitor); more > 0;)
    {
      islands += more;
      more = segment::RemoveIslands(work, limits, monitor);
    }
    if (islands > 0)
    {
      work.Recount("island given to its neighbour", monitor);
    }
    if (pass > 1 && walls + islands == 0)
    {
      return;
    }
    SubMonitor repairing(monitor, share(2 * pass - 1), share(2 * pass));
    const Id repaired = segment::Repair(work, repairing);
    if (repaired > 0)
    {
      work.Recount("topology repaired", monitor);
    }
    if (walls + islands + repaired == 0)
    {
      return;
    }
  }
  segment::BuildWalls(work, monitor);
  SubMonitor last(monitor, share(2 * mostPasses), 0.9);
  segment::Repair(work, last);
}

/// The first half of the work: what each voxel is by its grey value and its nearest neighbours.
void DecideVoxels(Work& work, Monitor& monitor)
{
  monitor.Progress(0.05, "applying thresholds");
  segment::Classify(work, monitor);
  segment::MeasureClasses(work, monitor);
  if (monitor.Cancelled())
  {
    return;
  }
  monitor.Progress(0.05, "counting holes and tunnels");
  work.report.before = segment::CountBetti(work, monitor);
  segment::Classify(work, monitor);
  work.Recount("thresholds", monitor);
  if (monitor.Cancelled())
  {
    return;
  }
  NoteClasses(work);
  monitor.Progress(0.15, "resolving disputed voxels");
  segment::ResolveUndecided(work, monitor);
  work.Recount("disputed", monitor);
  monitor.Progress(0.25, "dissolving skins");
  segment::DissolveSkins(work, monitor);
  work.Recount("skin dissolved", monitor);
  work.grey = GreyView(); // the smoothed values are needed no more
}

Result<bool> CheckOutcome(const SegmentReport& report)
{
  const bool any = std::any_of(report.after.begin(), report.after.end(),
                               [](const BettiNumbers& b) { return b.material > 0 && b.voxels > 0; });
  if (!any)
  {
    std::ostringstream text;
    text.precision(10);
    text << "nothing but background is left after segmentation (image range " << report.least << " to "
         << report.greatest << "): move the thresholds, widen the mask or lower the least component size";
    return InvalidInput(text.str());
  }
  return true;
}

} // namespace

Result<SegmentReport> Segment(const GreyView& grey, LabelImage& labels, std::vector<unsigned char>& flags,
                              const SegmentOptions& asked, Monitor& monitor)
{
  SegmentReport report;
  SegmentOptions options = asked;
  const Result<bool> good = segment::Check(grey, options, report, monitor);
  if (!good)
  {
    return good.GetError();
  }
  report.thresholds = options.thresholds;
  monitor.Progress(0.0, "smoothing");
  GreyView smooth = segment::Smoothed(grey, options, report, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  labels.grid = grey.grid;
  labels.labels.assign(grey.Count(), 0);
  flags.assign(grey.Count(), 0);
  RegionMask trimmed;
  if (options.mask && options.openAtMaskBorder)
  {
    trimmed = segment::TrimMask(*options.mask, monitor);
    options.mask = &trimmed;
  }
  Work work{ std::move(smooth), options, labels, labels.labels, flags, report, {}, {} };
  DecideVoxels(work, monitor);
  if (!monitor.Cancelled())
  {
    CleanUp(work, monitor);
  }
  if (!monitor.Cancelled())
  {
    segment::FlagFaults(work, monitor);
    monitor.Progress(0.95, "counting holes and tunnels");
    report.after = segment::CountBetti(work, monitor);
  }
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  for (unsigned char& flag : flags)
  {
    flag &= FlagDisputed | FlagFault | FlagRepaired;
  }
  const Result<bool> some = CheckOutcome(report);
  if (!some)
  {
    return some.GetError();
  }
  return report;
}

} // namespace lamina
