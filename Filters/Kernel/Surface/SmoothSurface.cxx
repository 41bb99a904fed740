// SPDX-License-Identifier: BSD-3-Clause
#include "SmoothSurface.h"

#include "../Mesh/Closedness.h"
#include "../Search/SelfIntersection.h"
#include "Smoother.h"

#include <algorithm>

namespace lamina
{

namespace
{

std::optional<Error> CheckOptions(const SmoothSurfaceOptions& options)
{
  if (options.sweeps < 0)
  {
    return InvalidOption("the number of sweeps must be 0 or more, not " + std::to_string(options.sweeps));
  }
  if (!(options.relaxation > 0 && options.relaxation <= 1))
  {
    return InvalidOption("the relaxation must lie in (0, 1], not " + std::to_string(options.relaxation));
  }
  if (!(options.wavelength >= 0 && options.wavelength <= 100))
  {
    return InvalidOption("the wavelength must lie in [0, 100] mean edge lengths, not " +
                         std::to_string(options.wavelength));
  }
  if (!(options.largestDrift > 0))
  {
    return InvalidOption("the largest drift must be positive, not " + std::to_string(options.largestDrift));
  }
  if (!(options.largestDisplacement > 0))
  {
    return InvalidOption("the largest displacement must be positive, not " +
                         std::to_string(options.largestDisplacement));
  }
  if (!(options.settled >= 0))
  {
    return InvalidOption("the move that counts as settled must be 0 or more, not " +
                         std::to_string(options.settled));
  }
  return std::nullopt;
}

/// Where the surface is open, meets itself or intersects, its points are pinned; an error if that is not
/// accepted.
std::optional<Error> CheckSurface(const TriangleComplex& surface, const SmoothSurfaceOptions& options,
                                  SmoothingGoal& goal, SmoothSurfaceReport& report, Monitor& monitor)
{
  if (!options.acceptFaults)
  {
    if (auto error = CheckClosed(surface, true, monitor))
    {
      return error;
    }
    return options.sweeps > 0
             ? CheckEmbedded(surface.points, surface.triangles, "the surface to smooth", monitor)
             : std::nullopt;
  }
  if (auto error = CheckArrays(surface))
  {
    return error;
  }
  goal.pinned.assign(surface.points.size(), 0);
  for (const OpenEdge& edge : FindOpenEdges(surface, monitor))
  {
    ++report.faultyEdges;
    goal.pinned[static_cast<std::size_t>(edge.a)] = 1;
    goal.pinned[static_cast<std::size_t>(edge.b)] = 1;
  }
  goal.intersecting = FindIntersections(surface.points, surface.triangles, monitor);
  report.faultyPairs = static_cast<Id>(goal.intersecting.size());
  for (const auto& pair : goal.intersecting)
  {
    for (const Id t : pair)
    {
      for (const Id p : surface.triangles[static_cast<std::size_t>(t)])
      {
        goal.pinned[static_cast<std::size_t>(p)] = 1;
      }
    }
  }
  return monitor.Cancelled() ? std::optional<Error>(Cancelled()) : std::nullopt;
}

/// The volumes to hold, and where the surface has to move for them.
void SetVolumes(const TriangleComplex& surface, SmoothingGoal& goal)
{
  goal.regions = MakeRegions(surface);
  goal.volumes = ShellVolumes(surface, goal.regions);
  const std::vector<double> missing = MissingVolumes(surface, goal.regions);
  for (std::size_t r = 0; r < missing.size(); ++r)
  {
    goal.volumes[r] += missing[r];
  }
}

/// The sweeps; false if cancelled.
bool Smooth(TriangleComplex& surface, const SmoothSurfaceOptions& options, const SmoothingGoal& goal,
            double unit, SmoothSurfaceReport& report, Monitor& monitor)
{
  // The bounds on moves have never failed to keep surfaces apart so far, but only the exact test proves it:
  // where it finds fault, all is done again with a test after every phase.
  for (bool careful : { false, true })
  {
    report.sweepsDone = 0;
    report.movesRefused = 0;
    std::vector<Vec3> start;
    {
      Smoother smoother(surface, options, goal, unit, careful);
      smoother.Run(report, monitor);
      start = smoother.TakeStart();
    }
    if (!monitor.Cancelled())
    {
      report.certificate = Certify(surface, monitor);
    }
    const bool isCertified =
      !monitor.Cancelled() &&
      report.certificate.intersectingPairs == static_cast<Id>(goal.intersecting.size()) &&
      (goal.intersecting.empty() || NewIntersections(surface, goal.intersecting, monitor).empty());
    if (monitor.Cancelled() || (!isCertified && !careful))
    {
      surface.points = std::move(start);
    }
    if (monitor.Cancelled() || isCertified)
    {
      break;
    }
  }
  return !monitor.Cancelled();
}

void ReportVolumes(const TriangleComplex& surface, const SmoothingGoal& goal, double unit,
                   SmoothSurfaceReport& report)
{
  constexpr double voxelsOfPiece = 100;
  const double voxel = VoxelPerMeanEdge * unit;
  const double leastPiece = voxelsOfPiece * voxel * voxel * voxel;
  report.volumesAfter = MaterialVolumes(surface, report.materials);
  report.volumesHeld.assign(report.materials.size(), 0);
  report.pieces = goal.regions.ShellCount();
  const std::vector<double> volumes = ShellVolumes(surface, goal.regions);
  std::vector<Vec3> places(volumes.size());
  for (std::size_t t = surface.triangles.size(); t-- > 0;)
  {
    for (const int r : goal.regions.shellsOfSheet[static_cast<std::size_t>(goal.regions.sheetOfTriangle[t])])
    {
      if (r >= 0)
      {
        places[static_cast<std::size_t>(r)] =
          surface.points[static_cast<std::size_t>(surface.triangles[t][0])];
      }
    }
  }
  for (std::size_t r = 0; r < volumes.size(); ++r)
  {
    const int material = goal.regions.materialOfShell[r];
    const double target = goal.volumes[r];
    const double error = std::abs(volumes[r] - target);
    if (target >= leastPiece)
    {
      report.largestPieceError = std::max(report.largestPieceError, error / target);
    }
    if (error > 1e-9 * std::max(std::abs(target), leastPiece))
    {
      report.missedPieces.push_back({ material, target, volumes[r], places[r] });
    }
    const auto m = std::lower_bound(report.materials.begin(), report.materials.end(), material);
    if (m != report.materials.end() && *m == material)
    {
      report.volumesHeld[static_cast<std::size_t>(m - report.materials.begin())] += target;
    }
  }
  for (std::size_t m = 0; m < report.materials.size(); ++m)
  {
    report.largestVolumeChange =
      std::max(report.largestVolumeChange,
               std::abs(report.volumesAfter[m] - report.volumesHeld[m]) / std::abs(report.volumesHeld[m]));
  }
}

} // namespace

Result<SmoothSurfaceReport> SmoothSurface(TriangleComplex& surface, const SmoothSurfaceOptions& options,
                                          Monitor& monitor)
{
  if (const auto error = CheckOptions(options))
  {
    return *error;
  }
  SmoothSurfaceReport report;
  SmoothingGoal goal;
  if (const auto error = CheckSurface(surface, options, goal, report, monitor))
  {
    return *error;
  }
  report.materials = MaterialsOf(surface);
  report.volumesBefore = MaterialVolumes(surface, report.materials);
  if (surface.junctionKind.size() != surface.points.size())
  {
    ClassifyJunctions(surface);
  }
  const double unit = MeanEdgeLength(surface);
  if (options.sweeps == 0 || !(unit > 0))
  {
    report.volumesHeld = report.volumesBefore;
    report.volumesAfter = report.volumesBefore;
    report.certificate = Certify(surface, monitor);
    return report;
  }
  SetVolumes(surface, goal);
  const std::vector<unsigned char> kinds = surface.junctionKind;
  for (std::size_t p = 0; p < goal.pinned.size(); ++p)
  {
    surface.junctionKind[p] = goal.pinned[p] ? static_cast<unsigned char>(JunctionCorner) : kinds[p];
  }
  const bool done = Smooth(surface, options, goal, unit, report, monitor);
  surface.junctionKind = kinds;
  if (!done)
  {
    return Cancelled();
  }
  surface.missing.clear();
  ReportVolumes(surface, goal, unit, report);
  monitor.Progress(1, "smoothed");
  return report;
}

} // namespace lamina
