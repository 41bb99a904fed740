// SPDX-License-Identifier: BSD-3-Clause
#include "Segment.h"
#include "SegmentRules.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <tuple>
#include <utility>

namespace lamina
{

namespace
{

using segment::Work;

template<typename... Parts>
std::string Text(const Parts&... parts)
{
  std::ostringstream stream;
  stream.precision(10);
  (stream << ... << parts);
  return stream.str();
}

std::string SizeText(const std::array<Id, 3>& size)
{
  return Text(size[0], " x ", size[1], " x ", size[2]);
}

/// Least and greatest finite value; least > greatest if there is none.
std::pair<double, double> FiniteRange(const std::vector<double>& values)
{
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  for (const double value : values)
  {
    if (std::isfinite(value))
    {
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    }
  }
  return { least, greatest };
}

Result<bool> CheckImage(const GreyImage& grey)
{
  const auto& size = grey.grid.size;
  if (grey.grid.Count() <= 0 || grey.values.empty())
  {
    return InvalidInput("the image is empty: no voxel to segment");
  }
  if (static_cast<Id>(grey.values.size()) != grey.grid.Count())
  {
    return InvalidInput(
      Text("the image has ", grey.values.size(), " values for ", SizeText(size), " voxels"));
  }
  if (std::min({ size[0], size[1], size[2] }) < 2)
  {
    return InvalidInput(Text("the image is not three-dimensional: ", SizeText(size),
                             " voxels; stack the slices into one volume"));
  }
  return true;
}

Result<bool> CheckThresholds(const std::vector<double>& thresholds)
{
  if (thresholds.empty())
  {
    return InvalidOption(
      "no thresholds given: three make background, tissue, disputed and blood, two leave disputed out");
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

Result<bool> CheckRange(const SegmentOptions& options, double least, double greatest)
{
  if (!(least <= greatest))
  {
    return InvalidInput("the image holds no finite value");
  }
  if (least == greatest)
  {
    return InvalidInput(Text("the image is constant: every voxel is ", least));
  }
  for (const double threshold : options.thresholds)
  {
    if (threshold <= least || threshold > greatest)
    {
      return InvalidOption(Text("threshold ", threshold, " is outside the image's range ", least, " to ",
                                greatest, ": one class would be empty; choose thresholds inside it"));
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
  return true;
}

Result<bool> CheckMask(const GreyImage& grey, const LabelImage* mask, std::vector<std::string>& warnings)
{
  if (!mask)
  {
    return true;
  }
  const GridGeometry& a = grey.grid;
  const GridGeometry& b = mask->grid;
  if (a.size != b.size || static_cast<Id>(mask->labels.size()) != a.Count())
  {
    return InvalidInput(Text("the mask has ", SizeText(b.size), " voxels and the image ", SizeText(a.size),
                             ": resample the mask onto the image"));
  }
  if (std::find(mask->labels.begin(), mask->labels.end(), 1) == mask->labels.end())
  {
    return InvalidInput(
      "the mask is 1 nowhere: no voxel is left; the region of interest must be marked with 1");
  }
  const Vec3 far = a.ToWorld(a.size[0], a.size[1], a.size[2]) - b.ToWorld(b.size[0], b.size[1], b.size[2]);
  const double voxel = std::min({ a.spacing.x, a.spacing.y, a.spacing.z });
  if (std::max(Norm(a.origin - b.origin), Norm(far)) > 0.5 * voxel)
  {
    warnings.push_back(
      "the mask lies elsewhere in the world than the image (origin, spacing or direction differ); "
      "it is applied voxel by voxel");
  }
  return true;
}

/// What cannot be segmented, before any work. The image's range goes into the report.
Result<bool> Check(const GreyImage& grey, const SegmentOptions& options, SegmentReport& report)
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
    std::tie(report.least, report.greatest) = FiniteRange(grey.values);
    good = CheckRange(options, report.least, report.greatest);
  }
  return good ? CheckMask(grey, options.mask, report.warnings) : good;
}

/// Walls and islands undo each other's work at places: repeat until neither changes a voxel. The last word is
/// the walls', so that blood has its wall even where the passes run out.
void CleanUp(Work& work, Monitor& monitor)
{
  constexpr int mostPasses = 50;
  const segment::IslandLimits limits = segment::MakeIslandLimits(work);
  for (int pass = 1; pass <= mostPasses && !monitor.Cancelled(); ++pass)
  {
    monitor.Progress(0.3 + 0.6 * (pass - 1) / (pass + 2), "building walls, removing islands");
    const Id walls = segment::BuildWalls(work, monitor);
    // An island inside an island has its turn once the outer one is gone, before walls are built around
    // either.
    Id islands = 0;
    for (Id more = segment::RemoveIslands(work, limits, monitor); more > 0;)
    {
      islands += more;
      more = segment::RemoveIslands(work, limits, monitor);
    }
    work.report.passes = pass;
    if (walls + islands == 0)
    {
      return;
    }
  }
  segment::BuildWalls(work, monitor);
}

Result<bool> CountMaterials(Work& work, Monitor& monitor)
{
  for (int& label : work.labels)
  {
    label = std::max(label, 0);
  }
  const ComponentMap map = FindComponents(work.labels, work.Size(), Connectivity::Faces, monitor);
  std::vector<SegmentMaterial> materials(work.options.thresholds.size() + 1);
  for (const Component& component : map.components)
  {
    SegmentMaterial& material = materials[component.label];
    material.voxels += component.voxels;
    material.components += 1;
  }
  bool any = false;
  for (std::size_t id = 0; id < materials.size(); ++id)
  {
    materials[id].id = static_cast<int>(id);
    any = any || (id > 0 && materials[id].voxels > 0);
    if (id == 0 || materials[id].voxels > 0)
    {
      work.report.materials.push_back(materials[id]);
    }
  }
  if (!any)
  {
    return InvalidInput(Text("nothing but background is left after segmentation (image range ",
                             work.report.least, " to ", work.report.greatest,
                             "): move the thresholds, widen the mask or lower the least component size"));
  }
  return true;
}

} // namespace

void Work::Note(const char* rule, int material, Id components, Id voxels)
{
  auto& rules = this->report.rules;
  const auto same =
    std::find_if(rules.begin(), rules.end(),
                 [&](const SegmentRule& known) { return known.name == rule && known.material == material; });
  if (same == rules.end())
  {
    rules.push_back({ rule, material, components, voxels });
    return;
  }
  same->components += components;
  same->voxels += voxels;
}

Result<SegmentReport> Segment(const GreyImage& grey, LabelImage& labels, std::vector<unsigned char>& disputed,
                              const SegmentOptions& options, Monitor& monitor)
{
  SegmentReport report;
  const Result<bool> good = Check(grey, options, report);
  if (!good)
  {
    return good.GetError();
  }
  labels.grid = grey.grid;
  labels.labels.assign(grey.values.size(), 0);
  disputed.assign(grey.values.size(), 0);
  Work work{ grey, options, labels.labels, disputed, report };
  monitor.Progress(0.0, "applying thresholds");
  segment::Classify(work, monitor);
  monitor.Progress(0.1, "resolving disputed voxels");
  segment::ResolveUndecided(work, monitor);
  CleanUp(work, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  monitor.Progress(0.95, "counting components");
  const Result<bool> some = CountMaterials(work, monitor);
  if (!some)
  {
    return some.GetError();
  }
  return report;
}

} // namespace lamina
