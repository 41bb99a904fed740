// SPDX-License-Identifier: BSD-3-Clause
#include "Audit.h"

#include "../Geometry/Predicates.h"
#include "../Geometry/Quality.h"
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

constexpr Id Grain = 8192;

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

template<std::size_t N>
std::array<Vec3, N> Nodes(const VolumeMesh& mesh, Id cell)
{
  std::array<Vec3, N> nodes;
  for (std::size_t k = 0; k < N; ++k)
  {
    nodes[k] = mesh.points[Index(mesh.Cell(cell)[k])];
  }
  return nodes;
}

struct CellMeasure
{
  bool isValid = false;
  double quality = 0;
  double volume = 0;
};

CellMeasure Measure(const VolumeMesh& mesh, Id cell)
{
  switch (mesh.types[Index(cell)])
  {
    case CellType::Wedge:
    {
      const auto n = Nodes<6>(mesh, cell);
      return { WedgeIsValid(n), WedgeQuality(n), WedgeVolume(n) };
    }
    case CellType::Pyramid:
    {
      const auto n = Nodes<5>(mesh, cell);
      return { PyramidIsValid(n), PyramidQuality(n), PyramidVolume(n) };
    }
    default:
    {
      const auto n = Nodes<4>(mesh, cell);
      return { Orientation(n[0], n[1], n[2], n[3]) > 0, TetQuality(n[0], n[1], n[2], n[3]),
               TetVolume(n[0], n[1], n[2], n[3]) };
    }
  }
}

/// Least, first percentile and median of unsorted values.
std::array<double, 3> Percentiles(std::vector<double>& values)
{
  if (values.empty())
  {
    return { { 1, 1, 1 } };
  }
  const auto at = [&](double share)
  {
    const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  return { { *std::min_element(values.begin(), values.end()), at(0.01), at(0.5) } };
}

/// What is gathered of one material before it becomes its MaterialAudit.
struct Gathered
{
  MaterialAudit audit;
  long double volume = 0;
  std::vector<double> tets;
  std::vector<double> wedges;
};

MaterialAudit Close(Gathered& g, double gate)
{
  MaterialAudit& a = g.audit;
  a.meshVolume = static_cast<double>(g.volume);
  a.surfaceVolume = std::numeric_limits<double>::quiet_NaN();
  const auto above = std::count_if(g.tets.begin(), g.tets.end(), [&](double q) { return q > gate; });
  a.tetAboveGate = g.tets.empty() ? 1 : static_cast<double>(above) / static_cast<double>(g.tets.size());
  const auto tets = Percentiles(g.tets);
  const auto wedges = Percentiles(g.wedges);
  a.tetQualityMin = tets[0];
  a.tetQualityP1 = tets[1];
  a.tetQualityP50 = tets[2];
  a.wedgeQualityMin = wedges[0];
  a.wedgeQualityP1 = wedges[1];
  a.wedgeQualityP50 = wedges[2];
  return a;
}

/// Validity, quality and volume of every cell; the materials in ascending order.
void AuditCells(const VolumeMesh& mesh, const AuditOptions& options, AuditReport& report, AuditMarks& marks,
                Monitor& monitor)
{
  std::vector<double> volumes(mesh.types.size());
  monitor.For(mesh.CellCount(), Grain,
              [&](Id begin, Id end)
              {
                for (Id c = begin; c < end; ++c)
                {
                  const CellMeasure measure = Measure(mesh, c);
                  const bool isBadTet =
                    mesh.types[Index(c)] == CellType::Tetrahedron && !(measure.quality > options.qualityGate);
                  marks.quality[Index(c)] = measure.quality;
                  marks.flags[Index(c)] = static_cast<unsigned char>((measure.isValid ? 0 : FlagInverted) |
                                                                     (isBadTet ? FlagBadQuality : 0));
                  volumes[Index(c)] = measure.volume;
                }
              });
  std::map<int, Gathered> gathered;
  Places inverted;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    Gathered& g = gathered[mesh.materials[Index(c)]];
    const CellType type = mesh.types[Index(c)];
    g.volume += volumes[Index(c)];
    g.audit.material = mesh.materials[Index(c)];
    g.audit.tets += type == CellType::Tetrahedron;
    g.audit.wedges += type == CellType::Wedge;
    g.audit.pyramids += type == CellType::Pyramid;
    if (type == CellType::Tetrahedron)
    {
      g.tets.push_back(marks.quality[Index(c)]);
    }
    else if (type == CellType::Wedge)
    {
      g.wedges.push_back(marks.quality[Index(c)]);
    }
    if ((marks.flags[Index(c)] & FlagInverted) != 0)
    {
      inverted.Add(mesh.points[Index(mesh.Cell(c)[0])]);
    }
  }
  for (auto& entry : gathered)
  {
    report.materials.push_back(Close(entry.second, options.qualityGate));
  }
  report.invertedCells = inverted.GetCount();
  inverted.Tell("cells are inverted or without volume somewhere", report.findings);
}

void AuditPoints(const VolumeMesh& mesh, AuditReport& report)
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

Result<AuditReport> AuditMesh(const VolumeMesh& mesh, const TriangleComplex* surface,
                              const AuditOptions& options, AuditMarks& marks, Monitor& monitor)
{
  if (auto error = CheckOptions(options))
  {
    return *error;
  }
  if (auto error = CheckMesh(mesh))
  {
    return *error;
  }
  if (auto error = surface != nullptr ? CheckArrays(*surface) : std::nullopt)
  {
    return *error;
  }
  AuditReport report;
  report.points = static_cast<Id>(mesh.points.size());
  report.cells = mesh.CellCount();
  marks.quality.assign(mesh.types.size(), 0);
  marks.flags.assign(mesh.types.size(), 0);
  monitor.Progress(0, "Measuring the cells");
  AuditCells(mesh, options, report, marks, monitor);
  AuditPoints(mesh, report);
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
