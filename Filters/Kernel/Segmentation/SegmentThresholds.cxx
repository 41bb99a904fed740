// SPDX-License-Identifier: BSD-3-Clause
// Thresholds that nobody gave.
#include "FlatModes.h"
#include "HistogramThresholds.h"
#include "SegmentRules.h"

namespace lamina
{
namespace segment
{

namespace
{

/// The image without its noise, of which no classes are known yet.
GreyView SmoothedBlindly(const GreyView& grey, const SegmentReport& known, Monitor& monitor)
{
  SegmentReport report = known;
  SegmentOptions blind;
  blind.thresholds.clear();
  if (!(EstimateNoise(grey, blind, report) > 0))
  {
    // More than half of the image may be padding without noise.
    const auto [low, high] = HistogramThresholds(grey, report.least, report.greatest, monitor);
    blind.thresholds = { low, high };
  }
  return Smoothed(grey, blind, report, monitor);
}

} // namespace

std::vector<double> SuggestThresholds(const GreyView& grey, SegmentReport& report, Monitor& monitor)
{
  monitor.Progress(0.0, "looking for thresholds");
  const GreyView smooth = SmoothedBlindly(grey, report, monitor);
  if (monitor.Cancelled())
  {
    return {};
  }
  report.modes = FlatModes(smooth, report.least, report.greatest, monitor);
  const std::vector<double> found = ModeThresholds(report.modes);
  if (!found.empty())
  {
    return found;
  }
  const auto [low, high] = HistogramThresholds(grey, report.least, report.greatest, monitor);
  return { low, high };
}

} // namespace segment
} // namespace lamina
