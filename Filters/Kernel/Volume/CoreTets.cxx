// SPDX-License-Identifier: BSD-3-Clause
#include "CoreTets.h"

#include "../Geometry/Quality.h"
#include "../Mesh/Adjacency.h"
#include "../Sizing/RefinementDemand.h"
#include "CoreTetsFill.h"
#include "CoreTetsInput.h"
#include "FrontCells.h"
#include "GradedPoints.h"
#include "ImproveFaces.h"
#include "ImproveStuck.h"
#include "MeshEstimate.h"

#include <algorithm>

namespace lamina
{
namespace
{

using Tet = std::array<Id, 4>;

constexpr double QualityGate = 0.1;
constexpr double ShapeFirst = 0.2; ///< tets below are bettered before it matters how they fit prisms

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

/// The mesh of the tets: the surface's points first, then the added ones that are used.
void Emit(const TriangleComplex& surface, const TetSet& set, VolumeMesh& mesh, CoreTetsReport& report)
{
  const std::size_t onSurface = surface.points.size();
  std::vector<Id> renumber(set.points.size(), -1);
  for (const Tet& tet : set.tets)
  {
    for (Id p : tet)
    {
      renumber[Index(p)] = 0;
    }
  }
  mesh = VolumeMesh{};
  for (std::size_t p = 0; p < set.points.size(); ++p)
  {
    if (p < onSurface || renumber[p] == 0)
    {
      renumber[p] = static_cast<Id>(mesh.points.size());
      mesh.points.push_back(set.points[p]);
      mesh.interfaceNodeIds.push_back(-1);
      mesh.layerIndex.push_back(-1);
    }
  }
  for (std::size_t t = 0; t < set.tets.size(); ++t)
  {
    Tet tet = set.tets[t];
    std::array<Vec3, 4> c;
    for (std::size_t k = 0; k < 4; ++k)
    {
      c[k] = set.points[Index(tet[k])];
      tet[k] = renumber[Index(tet[k])];
    }
    mesh.AddCell(CellType::Tetrahedron, tet, set.groups[t], 0);
    const double quality = TetQuality(c[0], c[1], c[2], c[3]);
    report.leastQuality = t == 0 ? quality : std::min(report.leastQuality, quality);
    report.aboveGate += quality > QualityGate;
  }
  report.tets = static_cast<Id>(set.tets.size());
  report.addedPoints = static_cast<Id>(mesh.points.size() - onSurface);
  report.aboveGate = report.tets > 0 ? (report.aboveGate - 1) / static_cast<double>(report.tets) : 1;
}

/// Betters the tets by their shape first, the stuck ones by force; then, if there are prisms behind the
/// surface, with an eye on these; the faces between cells at last.
void Improve(const TriangleComplex& surface, const CoreTetsOptions& asked, TetSet& set, Monitor& monitor)
{
  const FrontCells behind(surface);
  ImproveTetsOptions options;
  const bool hasPrisms = !surface.layerSide.empty();
  options.target = hasPrisms ? ShapeFirst : options.target;
  ImproveTets(set, options, monitor);
  if (asked.isThorough)
  {
    ImproveStuck(set, {}, monitor);
  }
  if (hasPrisms)
  {
    options = {};
    options.pointsBelow = 0.22; // up to where volumes jump by more than 3 (FrontCells.h)
    set.front = &behind;
    ImproveTets(set, options, monitor);
  }
  if (asked.isThorough)
  {
    ImproveFaces(set, {}, monitor);
  }
  set.front = nullptr;
}

Result<CoreTetsReport> Run(const TriangleComplex& surface, const std::vector<Vec3>& interior,
                           const CoreTetsOptions& options, VolumeMesh& mesh, Monitor& monitor,
                           CoreTetsReport& report)
{
  const MemoryDemand demand =
    CoreTetsDemand(surface, AsItIs(surface), MaterialsOf(surface), options.maximumEdge);
  if (const auto error = CheckMemory(demand, "tetrahedra", monitor))
  {
    return *error;
  }
  monitor.Progress(0, "Checking the surface");
  if (auto error = CheckCoreSurface(surface, interior, report, monitor))
  {
    return *error;
  }
  const std::vector<Vec3> graded = GradedPoints(surface, monitor);
  SubMonitor filling(monitor, 0.1, 0.8);
  auto filled = FillCore(surface, graded, interior, options, report, filling);
  if (!filled)
  {
    return filled.GetError();
  }
  TetSet& set = *filled;
  set.fixed.assign(set.points.size(), 0);
  std::fill_n(set.fixed.begin(), surface.points.size(), 1);
  SubMonitor improving(monitor, 0.85, 1);
  Improve(surface, options, set, improving);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  Emit(surface, set, mesh, report);
  monitor.Progress(1, "Core filled");
  return report;
}

} // namespace

Result<CoreTetsReport> MeshCoreTets(const TriangleComplex& surface, const std::vector<Vec3>& interiorPoints,
                                    const CoreTetsOptions& options, VolumeMesh& mesh, Monitor& monitor,
                                    CoreTetsReport* onFailure)
{
  CoreTetsReport report;
  if (auto error = CheckCoreOptions(options))
  {
    return *error;
  }
  if (surface.triangles.empty())
  {
    report = CoreTetsReport{};
    mesh = VolumeMesh{};
    mesh.points = surface.points;
    mesh.interfaceNodeIds.assign(mesh.points.size(), -1);
    mesh.layerIndex.assign(mesh.points.size(), -1);
    return report;
  }
  auto result = Run(surface, interiorPoints, options, mesh, monitor, report);
  if (!result && onFailure != nullptr)
  {
    *onFailure = report;
  }
  return result;
}

} // namespace lamina
