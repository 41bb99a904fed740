// SPDX-License-Identifier: BSD-3-Clause
// What refinement promises, measured on a given surface: MeasureRefinement FILE [NAME=VALUE]...
//
// FILE: .labels or .surface, as WriteRefinementInputs.py makes them, or .sized, which save=FILE.sized writes
// just before refinement. NAME: threads, iterations, tolerance, layers, minimum, maximum, uniform (one target
// for all, a length), verbose. The exit code is 2 if a promise is broken.
#include "GapMonitor.h"
#include "RefinementGates.h"
#include "SizedSurfaces.h"

#include <chrono>
#include <ctime>
#include <sys/resource.h>

using namespace lamina;

int main(int argc, char** argv)
{
  if (argc < 2)
  {
    std::printf("MeasureRefinement FILE [NAME=VALUE]...\n");
    return 1;
  }
  const Arguments arguments(argc, argv);
  const std::string path = argv[1];
  ThreadMonitor monitor(static_cast<int>(arguments.Get("threads", 2)));
  double voxel = 0;
  TriangleComplex surface = measures::Sized(path, arguments, voxel, monitor);
  if (const std::string save = arguments.Text("save"); !save.empty())
  {
    measures::Save(surface, voxel, save);
  }
  const double uniform = arguments.Get("uniform", 0);
  if (uniform > 0)
  {
    surface.targetEdgeLength.assign(surface.points.size(), uniform);
  }
  for (double& target : surface.targetEdgeLength)
  {
    target *= arguments.Get("scale", 1);
  }
  const TriangleComplex input = surface;
  RefineSurfaceOptions options;
  options.iterations = static_cast<int>(arguments.Get("iterations", options.iterations));
  options.tangentialAnisotropy = arguments.Get("stretch", 1);
  options.splitRatio = arguments.Get("split", options.splitRatio);
  options.mergeRatio = arguments.Get("merge", options.mergeRatio);
  options.tolerance = arguments.Get("tolerance", 0);
  const std::clock_t clock = std::clock();
  const auto begin = std::chrono::steady_clock::now();
  GapMonitor asked(static_cast<int>(arguments.Get("threads", 2)));
  const auto report = RefineSurface(surface, options, asked);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const double used = static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC;
  measures::Demand(report, "refine");
  rusage memory{};
  getrusage(RUSAGE_SELF, &memory);
  std::printf("%s: %zu -> %zu triangles, %.1f s (%.1f s of processors), %.2f GiB\n", path.c_str(),
              input.triangles.size(), surface.triangles.size(), seconds, used,
              static_cast<double>(memory.ru_maxrss) / (1 << 20));
  std::printf("  longest without a question whether to stop: %.2f s of processors (%s)\n", asked.Longest(),
              asked.Where().c_str());
  TriangleComplex even = input;
  even.targetEdgeLength.assign(
    input.points.size(), *std::min_element(input.targetEdgeLength.begin(), input.targetEdgeLength.end()));
  const auto count = static_cast<double>(surface.triangles.size());
  std::printf(
    "  triangles: %.2f times equilateral ones of the targets; all of the least target: %.1f times\n",
    count / measures::EquilateralTriangles(input), measures::EquilateralTriangles(even) / count);
  std::printf("  reported: %.3f %% of edges in range, %.4f %% of triangles above 0.4, least %.3f\n",
              100 * report->edgesInRange, 100 * report->goodTriangles, report->leastQuality);
  std::printf("  splits %lld, merges %lld, swaps %lld; hidden nodes %lld, of which the input forbids %lld\n",
              report->splits, report->merges, report->swaps, report->hiddenNodes, report->forbiddenNodes);
  if (arguments.Get("measure", 1) == 0)
  {
    return 0;
  }
  const measures::RefinementFigures figures =
    measures::Measure(input, surface, options, voxel, arguments.Get("verbose", 0) > 0, monitor);
  const std::vector<std::string> broken = measures::BrokenPromises(figures, *report);
  for (const std::string& promise : broken)
  {
    std::printf("  BROKEN: %s\n", promise.c_str());
  }
  return broken.empty() ? 0 : 2;
}
