// SPDX-License-Identifier: BSD-3-Clause
#include "SmoothSurface.h"

#include "../Mesh/Closedness.h"
#include "../Mesh/VolumeCorrection.h"
#include "../Search/SelfIntersection.h"
#include "Smoother.h"

#include <algorithm>

namespace lamina
{

Result<SmoothSurfaceReport> SmoothSurface(TriangleComplex& surface, const SmoothSurfaceOptions& options,
                                          Monitor& monitor)
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
  if (const std::optional<Error> error = CheckClosed(surface, true, monitor))
  {
    return *error;
  }
  SmoothSurfaceReport report;
  report.materials = MaterialsOf(surface);
  report.volumesBefore = MaterialVolumes(surface, report.materials);
  if (surface.junctionKind.size() != surface.points.size())
  {
    ClassifyJunctions(surface);
  }
  const double unit = MeanEdgeLength(surface);
  if (options.sweeps > 0 && unit > 0)
  {
    if (const auto error = CheckEmbedded(surface.points, surface.triangles, "the surface to smooth", monitor))
    {
      return *error;
    }
    const SheetGraph graph = MakeSheetGraph(surface);
    const std::vector<double> targets = ShellVolumes(surface, graph);
    // The bounds on moves have never failed to keep surfaces apart so far, but only the exact test proves it:
    // where it finds fault, all is done again with a test after every phase.
    const std::vector<Vec3> start = surface.points;
    for (bool careful : { false, true })
    {
      surface.points = start;
      report.sweepsDone = 0;
      report.movesRefused = 0;
      Smoother smoother(surface, options, unit, careful);
      if (!smoother.Run(report, monitor))
      {
        surface.points = start;
        return Cancelled();
      }
      if (FindIntersections(surface.points, surface.triangles, monitor).empty())
      {
        break;
      }
    }
    // Takes out the rounding errors of millions of moves, unless even that would make triangles meet.
    const std::vector<Vec3> smoothed = surface.points;
    RestoreVolumes(surface, graph, targets);
    if (!FindIntersections(surface.points, surface.triangles, monitor).empty())
    {
      surface.points = smoothed;
    }
  }
  report.volumesAfter = MaterialVolumes(surface, report.materials);
  for (std::size_t m = 0; m < report.materials.size(); ++m)
  {
    report.largestVolumeChange =
      std::max(report.largestVolumeChange, std::abs(report.volumesAfter[m] - report.volumesBefore[m]) /
                                             std::abs(report.volumesBefore[m]));
  }
  monitor.Progress(1, "smoothed");
  return report;
}

} // namespace lamina
