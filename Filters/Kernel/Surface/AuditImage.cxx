// SPDX-License-Identifier: BSD-3-Clause
#include "AuditImage.h"

#include "../Mesh/CellFaces.h"
#include "ImageVoxels.h"

#include <algorithm>
#include <map>

namespace lamina
{
namespace
{

constexpr Id Grain = 512;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

/// Area-weighted figures of distances.
InterfaceDistance Summarize(const MaterialPair& pair, std::vector<std::pair<double, double>>& samples)
{
  std::sort(samples.begin(), samples.end());
  InterfaceDistance d;
  d.pair = pair;
  double total = 0;
  for (const auto& sample : samples)
  {
    total += sample.second;
  }
  const auto at = [&](double share)
  {
    double sum = 0;
    for (const auto& sample : samples)
    {
      sum += sample.second;
      if (sum >= share * total)
      {
        return sample.first;
      }
    }
    return samples.back().first;
  };
  d.median = at(0.5);
  d.p95 = at(0.95);
  d.largest = samples.back().first;
  double within = 0;
  for (const auto& sample : samples)
  {
    within += sample.first <= 0.5 ? sample.second : 0;
  }
  d.within = within / total;
  return d;
}

void MeasureDistances(const VolumeMesh& mesh, const MeshPatches& patches, const ImageVoxels& voxels,
                      ImageAudit& audit, Monitor& monitor)
{
  std::vector<std::pair<double, double>> all(patches.faces.size());
  monitor.For(static_cast<Id>(patches.faces.size()), Grain,
              [&](Id begin, Id end)
              {
                for (Id f = begin; f < end; ++f)
                {
                  const PatchFace& face = patches.faces[Index(f)];
                  const MeshPatch& patch = patches.patches[Index(face.patch)];
                  const CellFace corners = FaceOf(mesh, face.cell, face.face);
                  const auto at = [&](std::size_t k) { return mesh.points[Index(corners.corners[k])]; };
                  const Vec3 middle = (at(0) + at(1) + at(2)) * (1.0 / 3);
                  all[Index(f)] = { voxels.ToBorder(middle, patch.pair) / voxels.Edge(),
                                    0.5 * Norm(Cross(at(1) - at(0), at(2) - at(0))) };
                }
              });
  std::map<MaterialPair, std::vector<std::pair<double, double>>> samples;
  for (std::size_t f = 0; f < all.size(); ++f)
  {
    const MeshPatch& patch = patches.patches[Index(patches.faces[f].patch)];
    if (patch.kind == PatchKind::Interface || patch.kind == PatchKind::Wall)
    {
      samples[patch.pair].push_back(all[f]);
    }
  }
  for (auto& [pair, list] : samples)
  {
    audit.interfaces.push_back(Summarize(pair, list));
  }
}

} // namespace

Result<ImageAudit> AuditAgainstImage(const VolumeMesh& mesh, const MeshPatches& patches,
                                     const LabelImage& image, double scale, Monitor& monitor)
{
  if (!(scale > 0 && std::isfinite(scale)))
  {
    return InvalidOption("scale must be above 0");
  }
  if (static_cast<Id>(image.labels.size()) != image.grid.Count())
  {
    return InvalidInput("the image has " + std::to_string(image.labels.size()) + " labels for " +
                        std::to_string(image.grid.Count()) + " voxels");
  }
  ImageAudit audit;
  const ImageVoxels voxels(image, scale);
  monitor.Progress(0, "Comparing with the voxels");
  CompareVolumes(mesh, voxels, audit);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  monitor.Progress(0.3, "Measuring distances to the voxels' border");
  MeasureDistances(mesh, patches, voxels, audit, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  return audit;
}

} // namespace lamina
