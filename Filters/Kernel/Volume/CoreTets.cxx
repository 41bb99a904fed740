// SPDX-License-Identifier: BSD-3-Clause
#include "CoreTets.h"

#include "../Geometry/Predicates.h"
#include "../Geometry/Quality.h"
#include "../Mesh/Adjacency.h"
#include "ChildProcess.h"
#include "CoreTetsInput.h"
#include "GradedPoints.h"
#include "ImproveTets.h"
#include "TetGenRun.h"
#include "TetRegions.h"

#include <algorithm>
#include <cstdio>

namespace lamina
{
namespace
{

using Tet = std::array<Id, 4>;

/// For the pace of the progress only.
constexpr double TetsPerTriangle = 4;
constexpr double TetsPerSecond = 20000;
constexpr double QualityGate = 0.1;
constexpr double RadiusOfEdge = 0.61237243569579447; ///< of a regular tet

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

/// The longest edge wanted near each point of the surface, as the circumradius of a regular tet, which is
/// what TetGen compares with.
std::vector<double> SizesWanted(const TriangleComplex& surface, const CoreTetsOptions& options)
{
  std::vector<double> wanted = MeanEdgesAtPoints(surface.points, surface.triangles);
  for (std::size_t p = 0; p < wanted.size(); ++p)
  {
    if (p < surface.targetEdgeLength.size() && surface.targetEdgeLength[p] > 0)
    {
      wanted[p] = surface.targetEdgeLength[p];
    }
    wanted[p] *= options.sizeFactor;
    wanted[p] = RadiusOfEdge * std::min(wanted[p], options.maximumEdge);
  }
  return wanted;
}

TetGenTask MakeTask(const TriangleComplex& surface, const std::vector<Vec3>& interior,
                    const CoreTetsOptions& options)
{
  TetGenTask task;
  task.points = surface.points;
  task.facets = surface.triangles;
  task.inserted = interior;
  task.holes = FindHoles(surface);
  if (options.maximumEdge > 0)
  {
    task.sizes = SizesWanted(surface, options);
  }
  char ratio[32];
  std::snprintf(ratio, sizeof ratio, "%.6g", options.radiusEdgeRatio);
  task.switches = std::string("Yq") + ratio;
  return task;
}

/// In a child process, or here if there is no program for it.
Result<TetGenAnswer> Ask(const TetGenTask& task, const CoreTetsOptions& options, Monitor& monitor)
{
  if (options.program.empty())
  {
    return RunTetGen(task);
  }
  const double seconds = TetsPerTriangle / TetsPerSecond * static_cast<double>(task.facets.size());
  auto bytes = RunChild(options.program, Encode(task), 1 + seconds, monitor);
  if (!bytes)
  {
    return bytes.GetError();
  }
  auto answer = DecodeAnswer(*bytes);
  if (!answer)
  {
    return Unreachable("the program " + options.program +
                       " gave no answer that makes sense: is it of this version?");
  }
  return std::move(*answer);
}

/// TetGen's answer against what it was asked.
std::optional<Error> CheckAnswer(const TriangleComplex& surface, const TetGenAnswer& answer,
                                 CoreTetsReport& report)
{
  if (answer.code != 0)
  {
    for (Id f : answer.facets)
    {
      if (f >= 0 && f < static_cast<Id>(surface.triangles.size()))
      {
        report.offendingTriangles.push_back(f);
      }
    }
    return Unreachable("TetGen could not fill the surface: " + answer.message,
                       CentresOf(surface, report.offendingTriangles));
  }
  const Id count = static_cast<Id>(answer.points.size());
  if (answer.points.size() < surface.points.size() ||
      !std::equal(surface.points.begin(), surface.points.end(), answer.points.begin()) ||
      !std::all_of(answer.points.begin(), answer.points.end(), IsFinite))
  {
    return Unreachable("TetGen did not hand back the surface's points as they were");
  }
  for (const Tet& tet : answer.tets)
  {
    if (*std::min_element(tet.begin(), tet.end()) < 0 || *std::max_element(tet.begin(), tet.end()) >= count)
    {
      return Unreachable("TetGen handed back a tetrahedron with a point that is not there");
    }
  }
  return std::nullopt;
}

/// Turns each tet to VTK's order.
std::optional<Error> Orient(TetSet& set)
{
  for (Tet& tet : set.tets)
  {
    const int sign = Orientation(set.points[Index(tet[0])], set.points[Index(tet[1])],
                                 set.points[Index(tet[2])], set.points[Index(tet[3])]);
    if (sign == 0)
    {
      return Unreachable("TetGen left a tetrahedron without volume", { set.points[Index(tet[0])] });
    }
    if (sign < 0)
    {
      std::swap(tet[2], tet[3]);
    }
  }
  return std::nullopt;
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

Result<CoreTetsReport> Run(const TriangleComplex& surface, const std::vector<Vec3>& interior,
                           const CoreTetsOptions& options, VolumeMesh& mesh, Monitor& monitor,
                           CoreTetsReport& report)
{
  monitor.Progress(0, "Checking the surface");
  if (auto error = CheckCoreSurface(surface, interior, report, monitor))
  {
    return *error;
  }
  std::vector<Vec3> inserted = GradedPoints(surface, monitor);
  inserted.insert(inserted.end(), interior.begin(), interior.end());
  const TetGenTask task = MakeTask(surface, inserted, options);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  SubMonitor asking(monitor, 0.1, 0.8);
  auto answer = Ask(task, options, asking);
  if (!answer)
  {
    return answer.GetError();
  }
  if (auto error = CheckAnswer(surface, *answer, report))
  {
    return *error;
  }
  TetSet set;
  set.points = std::move(answer->points);
  set.tets = std::move(answer->tets);
  if (auto error = Orient(set))
  {
    return *error;
  }
  if (auto error = AssignRegions(surface, set, monitor))
  {
    return *error;
  }
  set.fixed.assign(set.points.size(), 0);
  std::fill_n(set.fixed.begin(), surface.points.size(), 1);
  SubMonitor improving(monitor, 0.85, 1);
  ImproveTets(set, ImproveTetsOptions{}, improving);
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
