// SPDX-License-Identifier: BSD-3-Clause
// What cannot be segmented, found before any work.
#include "SegmentRules.h"

#include "../Base/Text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <sstream>

namespace lamina
{
namespace segment
{

namespace
{

/// Four digits are enough for thresholds to start from.
std::string Suggestion(const std::vector<double>& thresholds)
{
  std::ostringstream stream;
  stream.precision(4);
  for (std::size_t t = 0; t < thresholds.size(); ++t)
  {
    stream << (t == 0 ? "" : ", ") << thresholds[t];
  }
  return stream.str();
}

/// Least and greatest finite value into the report; least > greatest if there is none.
void FindRange(const GreyView& grey, SegmentReport& report, Monitor& monitor)
{
  report.least = std::numeric_limits<double>::infinity();
  report.greatest = -report.least;
  std::mutex guard;
  const Id length = grey.grid.size[0];
  monitor.For(grey.grid.size[1] * grey.grid.size[2], 256,
              [&](Id begin, Id end)
              {
                std::vector<double> row(length);
                double least = std::numeric_limits<double>::infinity();
                double greatest = -least;
                for (Id r = begin; r < end; ++r)
                {
                  grey.Read(r * length, (r + 1) * length, row.data());
                  for (const double value : row)
                  {
                    if (std::isfinite(value))
                    {
                      least = std::min(least, value);
                      greatest = std::max(greatest, value);
                    }
                  }
                }
                const std::lock_guard<std::mutex> lock(guard);
                report.least = std::min(report.least, least);
                report.greatest = std::max(report.greatest, greatest);
              });
}

Result<bool> CheckImage(const GreyView& grey)
{
  const auto& size = grey.grid.size;
  if (grey.grid.Count() <= 0 || grey.Count() == 0)
  {
    return InvalidInput("the image is empty: no voxel to segment");
  }
  if (grey.Count() != grey.grid.Count())
  {
    return InvalidInput(Text("the image has ", grey.Count(), " values for ", SizeText(size), " voxels"));
  }
  if (std::min({ size[0], size[1], size[2] }) < 2)
  {
    return InvalidInput(Text("the image is not three-dimensional: ", SizeText(size),
                             " voxels; stack the slices into one volume"));
  }
  if (grey.Count() > MostVoxelsOfComponents)
  {
    return InvalidInput(Text("the image has ", grey.Count(), " voxels, more than the ",
                             MostVoxelsOfComponents, " that can be handled: crop or coarsen it"));
  }
  return true;
}

Result<bool> CheckThresholds(const std::vector<double>& thresholds)
{
  if (thresholds.size() > LargestMaterial)
  {
    return InvalidOption(Text(thresholds.size(), " thresholds would make materials beyond ", LargestMaterial,
                              ", the largest id: give fewer"));
  }
  for (std::size_t i = 0; i < thresholds.size(); ++i)
  {
    if (!std::isfinite(thresholds[i]))
    {
      return InvalidOption(Text("threshold ", i + 1, " is not a number"));
    }
    if (i > 0 && !(thresholds[i - 1] < thresholds[i]))
    {
      return InvalidOption(
        Text("the thresholds are out of order: ", thresholds[i - 1], " is not below ", thresholds[i]));
    }
  }
  return true;
}

/// Thresholds that nobody gave come from the histogram.
Result<bool> CheckRange(const GreyView& grey, SegmentOptions& options, SegmentReport& report,
                        Monitor& monitor)
{
  const double least = report.least;
  const double greatest = report.greatest;
  if (!(least <= greatest))
  {
    return InvalidInput("the image holds no finite value");
  }
  if (least == greatest)
  {
    return InvalidInput(Text("the image is constant: every voxel is ", least));
  }
  if (options.thresholds.empty())
  {
    options.thresholds = SuggestThresholds(grey, report, monitor);
    if (monitor.Cancelled())
    {
      return Cancelled();
    }
    if (report.modes.size() < 2)
    {
      report.warnings.push_back(
        "the histogram of the image has but one peak, or none: its thresholds part it "
        "all the same, look at the result");
    }
    else if (report.modes.size() == 2)
    {
      report.warnings.push_back(Text(
        "two grey values fill places of the image, ", Short(report.modes[0]), " and ", Short(report.modes[1]),
        ", which makes one material: if there is another that is nowhere three voxels "
        "thick, give the thresholds"));
    }
    return true;
  }
  for (const double threshold : options.thresholds)
  {
    if (threshold <= least || threshold > greatest)
    {
      const std::vector<double> better = SuggestThresholds(grey, report, monitor);
      if (monitor.Cancelled())
      {
        return Cancelled();
      }
      return InvalidOption(Text("threshold ", threshold, " is outside the image's range ", least, " to ",
                                greatest, ": one class would be empty; its histogram suggests ",
                                Suggestion(better)));
    }
  }
  return true;
}

Result<bool> CheckOptions(const SegmentOptions& options)
{
  if (options.coronaryMajority < 1 || options.coronaryMajority > 27)
  {
    return InvalidOption(
      Text("the coronary majority is ", options.coronaryMajority, ", it must be 1 to 27 (27: off)"));
  }
  if (!(options.minimumShare >= 0 && options.minimumShare <= 1) || options.minimumVoxels < 0)
  {
    return InvalidOption(
      "the least component must be a share of 0 to 1 and a number of voxels of at least 0");
  }
  if (options.smoothingSweeps < 0 || options.smoothingSweeps > 20)
  {
    return InvalidOption(
      Text("the number of smoothing sweeps is ", options.smoothingSweeps, ", it must be 0 (off) to 20"));
  }
  if (options.keptCount < 1)
  {
    return InvalidOption(
      Text("the number of components to keep is ", options.keptCount, ", it must be at least 1"));
  }
  for (const auto& pair : options.forbidden)
  {
    if (std::min(pair[0], pair[1]) < 0 || std::max(pair[0], pair[1]) > LargestMaterial || pair[0] == pair[1])
    {
      return InvalidOption(Text("the forbidden contact of ", pair[0], " and ", pair[1],
                                " is none: it takes two different materials of 0 to ", LargestMaterial));
    }
  }
  return true;
}

Result<bool> CheckMask(const GreyView& grey, const RegionMask* mask)
{
  if (!mask)
  {
    return true;
  }
  const GridGeometry& a = grey.grid;
  const GridGeometry& b = mask->grid;
  if (a.size != b.size || static_cast<Id>(mask->inside.size()) != a.Count())
  {
    return InvalidInput(Text("the mask has ", SizeText(b.size), " voxels and the image ", SizeText(a.size),
                             ": resample the mask onto the image"));
  }
  if (std::all_of(mask->inside.begin(), mask->inside.end(), [](unsigned char in) { return in == 0; }))
  {
    return InvalidInput(
      "the mask is 1 nowhere: no voxel is left; the region of interest must be marked with 1");
  }
  return true;
}

} // namespace

Result<bool> Check(const GreyView& grey, SegmentOptions& options, SegmentReport& report, Monitor& monitor)
{
  Result<bool> good = CheckImage(grey);
  if (good)
  {
    good = CheckThresholds(options.thresholds);
  }
  if (good)
  {
    good = CheckOptions(options);
  }
  if (good)
  {
    FindRange(grey, report, monitor);
    good = monitor.Cancelled() ? Result<bool>(Cancelled()) : CheckMask(grey, options.mask);
  }
  return good ? CheckRange(grey, options, report, monitor) : good;
}

} // namespace segment
} // namespace lamina
