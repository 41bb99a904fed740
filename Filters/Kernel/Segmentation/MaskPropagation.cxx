// SPDX-License-Identifier: BSD-3-Clause
#include "MaskPropagation.h"

#include "../Base/Text.h"
#include "MaskCarrying.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace lamina
{

namespace
{

constexpr double PoorDice = 0.7; ///< of foretold slices, below which a user should draw more

struct Done
{
};

Result<Done> CheckOptions(const MaskPropagationOptions& options)
{
  if (options.axis < 0 || options.axis > 3)
  {
    return InvalidOption("slice axis " + std::to_string(options.axis) + ": 0 to 3 is needed");
  }
  if (options.method < 0 || options.method > 3)
  {
    return InvalidOption("method " + std::to_string(options.method) + ": 0 to 3 is needed");
  }
  if (options.maskValue < 0 || options.maskValue > LargestMaterial)
  {
    return InvalidOption("mask value " + std::to_string(options.maskValue) + ": 0 to 65535 is needed");
  }
  if (options.maximumSlices < -1)
  {
    return InvalidOption("maximum slices " + std::to_string(options.maximumSlices) +
                         ": -1 (automatic), 0 or more is needed");
  }
  if (options.levels < 1 || options.levels > 8)
  {
    return InvalidOption("levels " + std::to_string(options.levels) + ": 1 to 8 is needed");
  }
  if (!(options.smoothness >= 0.5 && options.smoothness <= 20))
  {
    return InvalidOption("smoothness " + std::to_string(options.smoothness) + ": 0.5 to 20 pixels is needed");
  }
  if (!(options.searchRange > 0) || !std::isfinite(options.searchRange))
  {
    return InvalidOption("search range " + std::to_string(options.searchRange) +
                         ": a positive number of pixels is needed");
  }
  return Done{};
}

Result<Done> CheckImages(const GreyImage& grey, const LabelImage& mask)
{
  if (grey.grid.size != mask.grid.size)
  {
    return InvalidInput("the mask has " + SizeText(mask.grid.size) + " voxels, the image " +
                        SizeText(grey.grid.size) + ": they must agree");
  }
  if (*std::min_element(grey.grid.size.begin(), grey.grid.size.end()) < 2)
  {
    return InvalidInput("the image has " + SizeText(grey.grid.size) + " voxels: a 3-D image is needed");
  }
  return Done{};
}

Id FirstOf(const CarryWork& work, const MaskPropagationOptions& options)
{
  return options.firstSlice[static_cast<std::size_t>(work.grid.axis)];
}

/// Find what was drawn and what is to be filled.
Result<Done> Prepare(const LabelImage& mask, const MaskPropagationOptions& options, CarryWork& work,
                     MaskPropagationReport& report, Monitor& monitor)
{
  const Result<std::vector<int>> ids = FindRegions(mask, options.maskValue, monitor);
  if (!ids)
  {
    return ids.GetError();
  }
  work.ids = *ids;
  const SliceFlags flags = FindSlices(mask, *ids, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  work.grid = SliceGrid(mask.grid, options.axis == 3 ? FindDrawnAxis(flags) : options.axis);
  const Result<std::vector<Id>> slices =
    FindDrawnSlices(flags, work.grid.axis, options.drawnSlices, FirstOf(work, options));
  if (!slices)
  {
    return slices.GetError();
  }
  work.drawn.resize(slices->size());
  monitor.For(static_cast<Id>(slices->size()), 1,
              [&](Id begin, Id end)
              {
                for (Id d = begin; d < end; ++d)
                {
                  const std::size_t n = static_cast<std::size_t>(d);
                  work.drawn[n] = ReadDrawnSlice(work.grid, mask, work.ids, (*slices)[n]);
                }
              });
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  work.gaps = FindGaps(work.grid, work.ids, options.maximumSlices, work.drawn);
  work.registration.levels = options.levels;
  work.registration.smoothness = options.smoothness;
  work.registration.searchRange = options.searchRange;
  report.axis = work.grid.axis;
  for (const Id slice : *slices)
  {
    report.drawn.push_back(slice + FirstOf(work, options));
  }
  report.ids = work.ids;
  return Done{};
}

/// Read the grey values of all slices that take part, and decide which methods are tried.
void PrepareGrey(const GreyImage& grey, int method, CarryWork& work, MaskPropagationReport& report,
                 Monitor& monitor)
{
  Id from = work.drawn.front().slice;
  Id to = work.drawn.back().slice + 1;
  for (const MaskGap& gap : work.gaps)
  {
    from = std::min(from, gap.Begin());
    to = std::max(to, gap.End() + 1);
  }
  work.stack = ReadSliceStack(work.grid, grey, work.drawn, from, to, monitor);
  work.registration.noise = work.stack.noise;
  report.noise = work.stack.noise * (work.stack.high - work.stack.low);
  if (work.stack.IsConstant())
  {
    report.warnings.push_back("the image is constant on and around the drawn mask: its shape alone is "
                              "interpolated; is this the image that the mask was drawn on?");
    work.methods = { CarryMethod::Shape };
    return;
  }
  work.methods = { CarryMethod::Shape, CarryMethod::Registration, CarryMethod::GreyValues };
  if (method > 0)
  {
    work.methods = { static_cast<CarryMethod>(method - 1) };
  }
}

/// The method that foretells best, the simpler one at a tie; the last one tried where nothing was measured.
CarryMethod Choose(const CarryWork& work, const Foretold& foretold)
{
  CarryMethod best = work.methods.front();
  for (const CarryMethod method : work.methods)
  {
    const double dice = foretold.dice[static_cast<std::size_t>(method)];
    const double other = foretold.dice[static_cast<std::size_t>(best)];
    best = std::isnan(dice) || dice > other ? method : best;
  }
  return best;
}

void WriteSlice(const SliceGrid& grid, Id slice, const std::vector<unsigned short>& labels, LabelImage& full)
{
  for (Id p = 0; p < grid.width * grid.height; ++p)
  {
    full.labels[static_cast<std::size_t>(grid.Voxel(slice, p % grid.width, p / grid.width))] =
      labels[static_cast<std::size_t>(p)];
  }
}

/// Write the slices of all gaps by the chosen method, and report on them.
void WriteGaps(const CarryWork& work, const std::vector<GapSlices>& made, std::size_t method, Id first,
               LabelImage& full, MaskPropagationReport& report)
{
  double sum = 0;
  double unregistered = 0;
  const double contrast = work.stack.high - work.stack.low;
  for (std::size_t g = 0; g < work.gaps.size(); ++g)
  {
    const MaskGap& gap = work.gaps[g];
    const Id from = work.Drawn(gap.low >= 0 ? gap.low : gap.high)->slice;
    const Id to = work.Drawn(gap.high >= 0 ? gap.high : gap.low)->slice;
    for (std::size_t n = 0; n < made[g].labels[method].size(); ++n)
    {
      const std::vector<unsigned short>& labels = made[g].labels[method][n];
      PropagatedSlice slice{ gap.first + static_cast<Id>(n), from, to, 0, 0 };
      slice.voxels = static_cast<Id>(labels.size()) - std::count(labels.begin(), labels.end(), 0);
      slice.residual = made[g].residuals[method][n] * contrast;
      sum += slice.residual;
      unregistered += made[g].residuals[0].empty() ? std::numeric_limits<double>::quiet_NaN()
                                                   : made[g].residuals[0][n] * contrast;
      WriteSlice(work.grid, slice.slice, labels, full);
      slice.slice += first;
      slice.from += first;
      slice.to += first;
      report.slices.push_back(slice);
    }
  }
  const double count = std::max<double>(1, static_cast<double>(report.slices.size()));
  report.residual = sum / count;
  report.unregisteredResidual = unregistered / count;
}

void WarnOfPoorForetelling(const CarryWork& work, const Foretold& foretold, Id first,
                           MaskPropagationReport& report)
{
  const double dice = foretold.dice[static_cast<std::size_t>(report.method - 1)];
  if (dice < PoorDice)
  {
    report.warnings.push_back(
      "the drawn slices hardly foretell each other (Dice coefficient " + std::to_string(dice).substr(0, 4) +
      "): the mask in between is doubtful; draw more slices, first around slice " +
      std::to_string(foretold.worst + first) + " across axis " + std::string(1, "ijk"[work.grid.axis]));
  }
}

/// Fill all gaps; the displacements of one gap are held at a time.
std::vector<GapEnds> FillGaps(const CarryWork& work, std::vector<GapSlices>& made, Monitor& monitor)
{
  std::vector<GapEnds> ends(work.gaps.size());
  made.resize(work.gaps.size());
  for (std::size_t g = 0; g < work.gaps.size() && !monitor.Cancelled(); ++g)
  {
    monitor.Progress(static_cast<double>(g) / static_cast<double>(work.gaps.size()), "Carrying the mask");
    GapFields fields;
    if (work.Registers())
    {
      RegisterGap(work, work.gaps[g], fields, monitor);
    }
    if (monitor.Cancelled())
    {
      break;
    }
    FillGap(work, work.gaps[g], fields, made[g], monitor);
    if (!fields.toLow.empty() && !fields.toHigh.empty())
    {
      ends[g] = { std::move(fields.toLow.back()), std::move(fields.toHigh.front()) };
    }
  }
  return ends;
}

} // namespace

Result<MaskPropagationReport> PropagateMask(const GreyImage& grey, const LabelImage& mask, LabelImage& full,
                                            const MaskPropagationOptions& options, Monitor& monitor)
{
  if (const Result<Done> fine = CheckOptions(options); !fine)
  {
    return fine.GetError();
  }
  if (const Result<Done> fine = CheckImages(grey, mask); !fine)
  {
    return fine.GetError();
  }
  const SliceWarper own;
  MaskPropagationReport report;
  CarryWork work;
  work.warper = options.warper ? options.warper : &own;
  if (const Result<Done> fine = Prepare(mask, options, work, report, monitor); !fine)
  {
    return fine.GetError();
  }
  PrepareGrey(grey, options.method, work, report, monitor);
  std::vector<GapSlices> made;
  const std::vector<GapEnds> ends = FillGaps(work, made, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  const Foretold foretold = ForetellDrawn(work, ends, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  report.foretold = foretold.dice;
  const CarryMethod chosen = Choose(work, foretold);
  report.method = static_cast<int>(chosen) + 1;
  full.grid = grey.grid;
  full.labels.assign(mask.labels.size(), 0);
  for (const DrawnSlice& drawn : work.drawn)
  {
    WriteSlice(work.grid, drawn.slice, { drawn.labels.begin(), drawn.labels.end() }, full);
  }
  WriteGaps(work, made, static_cast<std::size_t>(chosen), FirstOf(work, options), full, report);
  WarnOfPoorForetelling(work, foretold, FirstOf(work, options), report);
  return report;
}

} // namespace lamina
