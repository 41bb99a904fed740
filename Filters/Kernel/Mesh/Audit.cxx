// SPDX-License-Identifier: BSD-3-Clause
#include "Audit.h"

#include "AuditCells.h"
#include "AuditFaces.h"
#include "AuditOverlap.h"
#include "Closedness.h"
#include "Findings.h"
#include "PointTable.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>

namespace lamina
{
namespace
{

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

std::optional<Error> CheckOptions(const AuditOptions& o)
{
  if (!(o.qualityGate >= 0 && o.qualityGate <= 1))
  {
    return InvalidOption("qualityGate is " + std::to_string(o.qualityGate) + ", but must be in [0, 1]");
  }
  if (!(o.volumeTolerance > 0))
  {
    return InvalidOption("volumeTolerance is " + std::to_string(o.volumeTolerance) + ", but must be above 0");
  }
  if (!(o.surfaceScale > 0 && std::isfinite(o.surfaceScale)))
  {
    return InvalidOption("surfaceScale is " + std::to_string(o.surfaceScale) + ", but must be above 0");
  }
  if (o.overlapSamples < 0)
  {
    return InvalidOption("overlapSamples is " + std::to_string(o.overlapSamples) + ", but must be 0 or more");
  }
  return std::nullopt;
}

/// A mesh that does not pass cannot even be looked at.
std::optional<Error> CheckMesh(const VolumeMesh& mesh)
{
  const std::size_t cells = mesh.types.size();
  if (mesh.offsets.size() != cells + 1 || mesh.materials.size() != cells ||
      mesh.offsets.back() != static_cast<Id>(mesh.connectivity.size()))
  {
    return InvalidInput("the mesh's arrays do not agree in length: " + std::to_string(cells) + " cells, " +
                        std::to_string(mesh.materials.size()) + " materials");
  }
  for (std::size_t c = 0; c < cells; ++c)
  {
    if (mesh.offsets[c + 1] - mesh.offsets[c] != NodeCount(mesh.types[c]))
    {
      return InvalidInput("cell " + std::to_string(c) + " has a wrong number of nodes");
    }
  }
  const Id count = static_cast<Id>(mesh.points.size());
  const auto bad = std::find_if(mesh.connectivity.begin(), mesh.connectivity.end(),
                                [&](Id p) { return p < 0 || p >= count; });
  if (bad != mesh.connectivity.end())
  {
    return InvalidInput("a cell names the point " + std::to_string(*bad) + ", which is not there");
  }
  const auto strange = std::find_if_not(mesh.points.begin(), mesh.points.end(), IsFinite);
  if (strange != mesh.points.end())
  {
    return InvalidInput("point " + std::to_string(strange - mesh.points.begin()) +
                        " of the mesh is not a finite position");
  }
  return std::nullopt;
}

/// The node that stands for p: the lower of it and its twin.
Id Standing(const std::vector<Id>& twins, Id p)
{
  const Id twin = twins.empty() ? -1 : twins[Index(p)];
  return twin >= 0 && twin < p ? twin : p;
}

void AuditPoints(const VolumeMesh& mesh, const std::vector<Id>& twins, AuditReport& report)
{
  PointTable table(mesh.points.size());
  std::vector<char> used(mesh.points.size(), 0);
  for (Id p : mesh.connectivity)
  {
    used[Index(p)] = 1;
  }
  Places duplicates;
  Places unused;
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    if (Standing(twins, static_cast<Id>(p)) != static_cast<Id>(p))
    {
      continue;
    }
    const std::size_t before = table.GetPoints().size();
    if (Index(table.Insert(mesh.points[p])) != before)
    {
      duplicates.Add(mesh.points[p]);
    }
    if (used[p] == 0)
    {
      unused.Add(mesh.points[p]);
    }
  }
  report.duplicatePoints = duplicates.GetCount();
  report.unusedPoints = unused.GetCount();
  duplicates.Tell("points have the coordinates of another", report.findings);
  unused.Tell("points belong to no cell", report.findings);
}

/// The volume each material's triangles enclose, about an origin amid them, where the terms are smallest.
std::map<int, double> EnclosedVolumes(const TriangleComplex& surface, double scale)
{
  Vec3 low = surface.points.empty() ? Vec3{} : surface.points.front();
  Vec3 high = low;
  for (const Vec3& p : surface.points)
  {
    low = { std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z) };
    high = { std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z) };
  }
  const Vec3 origin = 0.5 * scale * (low + high);
  std::map<int, long double> sums;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Triangle& c = surface.triangles[t];
    const auto at = [&](std::size_t k) { return surface.points[Index(c[k])] * scale - origin; };
    const double six = Dot(Cross(at(0), at(1)), at(2));
    sums[surface.materials[t].first] += six;
    sums[surface.materials[t].second] -= six;
  }
  std::map<int, double> volumes;
  for (const auto& [material, sum] : sums)
  {
    volumes[material] = static_cast<double>(sum / 6);
  }
  return volumes;
}

void AuditVolumes(const TriangleComplex& surface, const AuditOptions& options, AuditReport& report)
{
  const auto volumes = EnclosedVolumes(surface, options.surfaceScale);
  for (MaterialAudit& material : report.materials)
  {
    const auto found = volumes.find(material.material);
    const std::string name = "material " + std::to_string(material.material);
    if (found == volumes.end() || material.material == 0)
    {
      report.findings.push_back(name + " is in the mesh but not in the surface");
      continue;
    }
    material.surfaceVolume = found->second;
    const double error =
      std::abs(material.meshVolume - material.surfaceVolume) / std::abs(material.surfaceVolume);
    report.largestVolumeError = std::max(report.largestVolumeError, error);
    if (!(error <= options.volumeTolerance))
    {
      char text[160];
      std::snprintf(text, sizeof text,
                    ": its cells have the volume %.12g, its surface encloses %.12g (relative %.3g)",
                    material.meshVolume, material.surfaceVolume, error);
      report.findings.push_back(name + text);
    }
  }
}

} // namespace

VolumeMesh MergeTwins(const VolumeMesh& mesh, const std::vector<Id>& twins, std::vector<Vec3>& mismatches)
{
  VolumeMesh merged = mesh;
  for (std::size_t p = 0; p < twins.size(); ++p)
  {
    const Id twin = twins[p];
    const bool isThere = twin >= 0 && twin < static_cast<Id>(twins.size());
    if (twin >= 0 && (!isThere || twins[Index(twin)] != static_cast<Id>(p) ||
                      !(mesh.points[p] == mesh.points[Index(twin)])))
    {
      mismatches.push_back(mesh.points[p]);
    }
  }
  for (Id& p : merged.connectivity)
  {
    const Id standing = Standing(twins, p);
    p = mesh.points[Index(standing)] == mesh.points[Index(p)] ? standing : p;
  }
  return merged;
}

Result<AuditReport> AuditMesh(const VolumeMesh& given, const TriangleComplex* surface,
                              const AuditOptions& options, AuditMarks& marks, Monitor& monitor)
{
  if (auto error = CheckOptions(options))
  {
    return *error;
  }
  if (auto error = CheckMesh(given))
  {
    return *error;
  }
  if (!options.twins.empty() && options.twins.size() != given.points.size())
  {
    return InvalidInput("there are " + std::to_string(options.twins.size()) + " twins for " +
                        std::to_string(given.points.size()) + " points");
  }
  if (auto error = surface != nullptr ? CheckArrays(*surface) : std::nullopt)
  {
    return *error;
  }
  AuditReport report;
  std::vector<Vec3> apart;
  const VolumeMesh merged = options.twins.empty() ? VolumeMesh{} : MergeTwins(given, options.twins, apart);
  Places twinPlaces;
  for (const Vec3& place : apart)
  {
    twinPlaces.Add(place);
  }
  report.twinMismatches = twinPlaces.GetCount();
  twinPlaces.Tell("twin nodes of an interface are not each other's, or not in the same place",
                  report.findings);
  const VolumeMesh& mesh = options.twins.empty() ? given : merged;
  report.points = static_cast<Id>(mesh.points.size());
  report.cells = mesh.CellCount();
  marks.quality.assign(mesh.types.size(), 0);
  marks.flags.assign(mesh.types.size(), 0);
  marks.boundary.clear();
  monitor.Progress(0, "Measuring the cells");
  AuditCells(mesh, options, report, marks, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  AuditPoints(mesh, options.twins, report);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  monitor.Progress(0.3, "Comparing the faces");
  AuditFaces(mesh, surface, options, report, marks, monitor);
  if (surface != nullptr)
  {
    AuditVolumes(*surface, options, report);
  }
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  monitor.Progress(0.8, "Looking for overlaps");
  AuditOverlap(mesh, surface, options, report, marks, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  monitor.Progress(1, "Mesh audited");
  return report;
}

} // namespace lamina
