// SPDX-License-Identifier: BSD-3-Clause
#include "HeartPhantom.h"
#include "ConnectedComponents.h"
#include "HeartShape.h"
#include "MendContacts.h"
#include "PhantomGrey.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace lamina
{

namespace
{

constexpr int TissueLabel = 1;
constexpr int BloodLabel = 2;
/// Voxels between the heart and the image's border, at least.
constexpr double Margin = 4;
/// The image is sampled in cubes of so many voxels, each with its own short list of vessels and strands.
constexpr Id Tile = 8;

Result<bool> Check(const HeartPhantomOptions& options)
{
  if (options.resolution < 16 || options.resolution > 512)
  {
    return InvalidOption("the resolution is " + std::to_string(options.resolution) +
                         " voxels, it must be 16 to 512");
  }
  if (!(options.length > 0) || !std::isfinite(options.length))
  {
    return InvalidOption("the length must be positive");
  }
  for (const double value : { options.blood, options.tissue, options.background })
  {
    if (!(value >= 0 && value <= 255))
    {
      return InvalidOption("grey values must be 0 to 255");
    }
  }
  if (!(options.noise >= 0 && options.noise <= 255) || !(options.blur >= 0 && options.blur <= 8) ||
      !(options.bias >= 0 && options.bias <= 1))
  {
    return InvalidOption("noise must be 0 to 255 grey levels, blur 0 to 8 voxels, bias 0 to 1");
  }
  return true;
}

/// A heart shape and how it lies in the image: voxel (i, j, k) is at `corner + voxel * (i, j, k)` in heart
/// units.
struct Placement
{
  HeartLevel level = HeartLevel::Whole;
  double voxel = 1;
  Vec3 corner;
  std::array<Id, 3> size{ { 0, 0, 0 } };
};

/// As much of a heart as so many voxels can show.
HeartLevel LevelFor(int resolution)
{
  if (resolution < 26)
  {
    return HeartLevel::Single;
  }
  return resolution < 36 ? HeartLevel::Ventricles
                         : (resolution < 64 ? HeartLevel::Chambers : HeartLevel::Whole);
}

/// The coarser the voxels, the thicker the thinnest walls in heart units and the larger the heart: iterate.
Placement Place(const HeartPhantomOptions& options)
{
  Placement placement;
  Vec3 least;
  Vec3 greatest;
  const double across = options.resolution - 2 * Margin;
  placement.level = LevelFor(options.resolution);
  double before = 0;
  for (int round = 0; round < 30 && std::abs(placement.voxel - before) > 1e-4 * before; ++round)
  {
    before = placement.voxel;
    HeartShape(before, placement.level, options.open).Bounds(least, greatest);
    const Vec3 extent = greatest - least;
    placement.voxel = std::max({ extent.x, extent.y, extent.z }) / across;
  }
  for (int a = 0; a < 3; ++a)
  {
    const double voxels = (greatest[a] - least[a]) / placement.voxel + 2 * Margin;
    placement.size[a] = std::min<Id>(options.resolution, static_cast<Id>(std::ceil(voxels - 0.01)));
    const double spare = placement.size[a] - 1 - (greatest[a] - least[a]) / placement.voxel;
    placement.corner[a] = least[a] - 0.5 * spare * placement.voxel;
  }
  if (options.open)
  {
    // Open vessels pass the border: cut the image where the closed ones would have ended.
    placement.size[2] -= static_cast<Id>(Margin);
  }
  return placement;
}

GridGeometry GridOf(const Placement& placement, const HeartPhantomOptions& options)
{
  const double spacing = options.length / *std::max_element(placement.size.begin(), placement.size.end());
  GridGeometry grid;
  grid.size = placement.size;
  grid.spacing = { spacing, spacing, spacing };
  return grid;
}

/// Sample the shape over the image: labels, and the distances for partial volume (in voxels, clamped to +-1).
void SampleShape(const HeartShape& shape, const Placement& placement, LabelImage& labels,
                 std::vector<HeartPart>& parts, PartialVolume& partial, Monitor& monitor)
{
  const auto& size = placement.size;
  const Id tiles[3] = { (size[0] + Tile - 1) / Tile, (size[1] + Tile - 1) / Tile,
                        (size[2] + Tile - 1) / Tile };
  const double h = placement.voxel;
  monitor.For(
    tiles[0] * tiles[1] * tiles[2], 4,
    [&](Id begin, Id end)
    {
      for (Id t = begin; t < end; ++t)
      {
        const Id first[3] = { t % tiles[0] * Tile, t / tiles[0] % tiles[1] * Tile,
                              t / (tiles[0] * tiles[1]) * Tile };
        const double half = 0.5 * (Tile - 1);
        const Vec3 centre = placement.corner + h * Vec3{ first[0] + half, first[1] + half, first[2] + half };
        const HeartShape::Nearby nearby = shape.Near(centre, std::sqrt(3.0) * half * h);
        for (Id k = first[2]; k < std::min(first[2] + Tile, size[2]); ++k)
        {
          for (Id j = first[1]; j < std::min(first[1] + Tile, size[1]); ++j)
          {
            for (Id i = first[0]; i < std::min(first[0] + Tile, size[0]); ++i)
            {
              const Vec3 p = placement.corner + h * Vec3{ double(i), double(j), double(k) };
              const HeartSample sample = shape.Sample(p, nearby);
              const Id voxel = labels.grid.Index(i, j, k);
              labels.labels[voxel] = sample.blood < 0 ? BloodLabel : (sample.heart < 0 ? TissueLabel : 0);
              parts[voxel] = sample.part;
              partial.heart[voxel] = PartialVolume::Encode(sample.heart / h);
              partial.blood[voxel] = PartialVolume::Encode(sample.blood / h);
            }
          }
        }
      }
    });
}

/// Sampling leaves crumbs where a structure is about to end: give them to what is around.
Id RemoveCrumbs(LabelImage& labels, int bloodComponents, Monitor& monitor)
{
  Id changed = 0;
  for (const int label : { 0, BloodLabel, TissueLabel })
  {
    const ComponentMap map = FindComponents(labels.labels, labels.grid.size, Connectivity::Faces, monitor);
    if (monitor.Cancelled())
    {
      return changed;
    }
    std::vector<Id> sizes;
    for (const Component& component : map.components)
    {
      if (component.label == label)
      {
        sizes.push_back(component.voxels);
      }
    }
    std::sort(sizes.rbegin(), sizes.rend());
    const std::size_t keep = label == BloodLabel ? static_cast<std::size_t>(bloodComponents) : 1;
    const Id least = sizes.size() > keep ? sizes[keep - 1] : 0;
    for (Id r = 0; r < map.size[1] * map.size[2] && least > 0; ++r)
    {
      for (Id at = map.rowStart[r]; at < map.rowStart[r + 1]; ++at)
      {
        const LabelRun& run = map.runs[at];
        if (run.label == label && map.components[run.component].voxels < least)
        {
          // A crumb of tissue floats in blood; crumbs of blood and background lie in the wall.
          const auto row = labels.labels.begin() + r * map.size[0];
          std::fill(row + run.begin, row + run.end, label == TissueLabel ? BloodLabel : TissueLabel);
          changed += run.end - run.begin;
        }
      }
    }
  }
  return changed;
}

/// What mending has made another material is the plainest part of that one.
void MendParts(const LabelImage& labels, std::vector<HeartPart>& parts)
{
  for (std::size_t v = 0; v < parts.size(); ++v)
  {
    const bool blood = parts[v] == HeartPart::Chamber || parts[v] == HeartPart::Coronary;
    const int material = blood ? BloodLabel : (parts[v] == HeartPart::Outside ? 0 : TissueLabel);
    if (material != labels.labels[v])
    {
      constexpr HeartPart plain[3] = { HeartPart::Outside, HeartPart::Wall, HeartPart::Chamber };
      parts[v] = plain[labels.labels[v]];
    }
  }
}

std::vector<HeartPhantomRod> InVoxels(const std::vector<TaperedRod>& rods, const Placement& placement)
{
  std::vector<HeartPhantomRod> placed;
  const double scale = 1 / placement.voxel;
  for (const TaperedRod& rod : rods)
  {
    placed.push_back({ (rod.from - placement.corner) * scale, (rod.to - placement.corner) * scale,
                       2 * rod.fromRadius * scale, 2 * rod.toRadius * scale });
  }
  return placed;
}

Result<HeartPhantomReport> CountMaterials(const LabelImage& labels, int bloodComponents, Monitor& monitor)
{
  const ComponentMap map = FindComponents(labels.labels, labels.grid.size, Connectivity::Faces, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  HeartPhantomReport report;
  for (int id = 0; id < 3; ++id)
  {
    report.materials.push_back({ id, 0, map.CountOf(id) });
  }
  for (const Component& component : map.components)
  {
    report.materials[component.label].voxels += component.voxels;
  }
  const auto& counted = report.materials;
  if (counted[TissueLabel].components != 1 || counted[BloodLabel].components != bloodComponents)
  {
    return Error{ Failure::Internal,
                  "the phantom fell into " + std::to_string(counted[TissueLabel].components) +
                    " pieces of tissue and " + std::to_string(counted[BloodLabel].components) +
                    " of blood, it was designed to have 1 and " + std::to_string(bloodComponents) +
                    "; another resolution helps",
                  {} };
  }
  return report;
}

} // namespace

Result<GridGeometry> HeartPhantomGrid(const HeartPhantomOptions& options)
{
  const Result<bool> good = Check(options);
  if (!good)
  {
    return good.GetError();
  }
  return GridOf(Place(options), options);
}

Result<HeartPhantomReport> MakeHeartPhantom(GreyImage& grey, LabelImage& labels,
                                            const HeartPhantomOptions& options, Monitor& monitor)
{
  const Result<bool> good = Check(options);
  if (!good)
  {
    return good.GetError();
  }
  monitor.Progress(0.0, "placing the heart");
  const Placement placement = Place(options);
  const HeartShape shape(placement.voxel, placement.level, options.open);
  labels.grid = GridOf(placement, options);
  labels.labels.assign(labels.grid.Count(), 0);
  PartialVolume partial(labels.grid.Count());
  std::vector<HeartPart> parts(labels.grid.Count());
  monitor.Progress(0.1, "sampling the heart");
  SampleShape(shape, placement, labels, parts, partial, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  monitor.Progress(0.5, "mending the true labels");
  Id mended = MendContacts(labels, TissueLabel);
  mended += RemoveCrumbs(labels, shape.BloodComponents(), monitor);
  mended += MendContacts(labels, TissueLabel);
  Result<HeartPhantomReport> report = CountMaterials(labels, shape.BloodComponents(), monitor);
  if (!report)
  {
    return report.GetError();
  }
  report->mendedVoxels = mended;
  MendParts(labels, parts);
  report->parts = std::move(parts);
  report->coronaries = InVoxels(shape.GetCoronaries(), placement);
  report->strands = InVoxels(shape.GetStrands(), placement);
  monitor.Progress(0.6, "making grey values");
  if (!MakeGreyValues(labels, partial, options, grey, monitor))
  {
    return Cancelled();
  }
  return report;
}

} // namespace lamina
