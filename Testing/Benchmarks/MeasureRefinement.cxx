// SPDX-License-Identifier: BSD-3-Clause
// What refinement promises, measured on a given surface: MeasureRefinement FILE [NAME=VALUE]...
//
// FILE: .labels or .surface, as WriteRefinementInputs.py makes them, or .sized, which save=FILE.sized writes
// just before refinement. NAME: threads, iterations, tolerance, layers, minimum, maximum, uniform (one target
// for all, a length), verbose.
#include "Arguments.h"
#include "Mesh/Adjacency.h"
#include "RefinementFiles.h"
#include "RefinementMeasures.h"
#include "Sizing/FeatureSize.h"
#include "Surface/ExtractInterfaces.h"
#include "Surface/SmoothSurface.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sys/resource.h>

using namespace lamina;

namespace
{

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

template<typename R>
void Demand(const R& result, const char* stage)
{
  if (!result)
  {
    std::printf("%s: %s\n", stage, result.GetError().message.c_str());
    std::exit(1);
  }
}

TriangleComplex FromLabels(std::ifstream& file, double& voxel, Monitor& monitor)
{
  LabelImage image;
  const auto size = Take<Id>(file, 3);
  const auto spacing = Take<double>(file, 3);
  image.grid.size = { { size[0], size[1], size[2] } };
  image.grid.spacing = { spacing[0], spacing[1], spacing[2] };
  image.labels = Take<int>(file, static_cast<std::size_t>(image.grid.Count()));
  voxel = std::min({ spacing[0], spacing[1], spacing[2] });
  TriangleComplex surface;
  Demand(ExtractInterfaces(image, surface, {}, monitor), "extract");
  Demand(SmoothSurface(surface, {}, monitor), "smooth");
  return surface;
}

/// Calls act(column) for everything that a sized surface holds.
template<typename Act>
void ForColumns(TriangleComplex& s, Act&& act)
{
  act(s.points);
  act(s.triangles);
  act(s.materials);
  act(s.patches);
  act(s.junctionKind);
  act(s.junctionOrder);
  act(s.featureSize);
  act(s.targetEdgeLength);
  act(s.sizedMaterials);
  act(s.thickness);
  act(s.maximumCurvature);
  act(s.minimumCurvature);
  act(s.maximumCurvatureDirection);
}

void Save(TriangleComplex& surface, double voxel, const std::string& path)
{
  std::ofstream file(path, std::ios::binary);
  const auto put = [&](const void* data, std::size_t bytes)
  { file.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes)); };
  put(&voxel, sizeof(voxel));
  ForColumns(surface,
             [&](const auto& column)
             {
               const Id count = static_cast<Id>(column.size());
               put(&count, sizeof(count));
               put(column.data(), column.size() * sizeof(column[0]));
             });
}

TriangleComplex Load(std::ifstream& file, double& voxel)
{
  TriangleComplex surface;
  voxel = Take<double>(file, 1)[0];
  ForColumns(surface,
             [&](auto& column)
             {
               using Value = typename std::decay_t<decltype(column)>::value_type;
               column = Take<Value>(file, static_cast<std::size_t>(Take<Id>(file, 1)[0]));
             });
  return surface;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 2)
  {
    std::printf("MeasureRefinement FILE [NAME=VALUE]...\n");
    return 1;
  }
  const Arguments arguments(argc, argv);
  const std::string path = argv[1];
  std::ifstream file(path, std::ios::binary);
  ThreadMonitor monitor(static_cast<int>(arguments.Get("threads", 2)));
  double voxel = 0;
  TriangleComplex surface;
  if (EndsWith(path, ".sized"))
  {
    surface = Load(file, voxel);
  }
  else
  {
    surface = EndsWith(path, ".labels") ? FromLabels(file, voxel, monitor) : FromTriangles(file);
    FeatureSizeOptions sizing;
    sizing.layers = static_cast<int>(arguments.Get("layers", sizing.layers));
    sizing.minimum = arguments.Get("minimum", 0);
    sizing.maximum = arguments.Get("maximum", 0);
    Demand(ComputeFeatureSize(surface, sizing, monitor), "size");
  }
  if (const std::string save = arguments.Text("save"); !save.empty())
  {
    Save(surface, voxel, save);
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
  const auto report = RefineSurface(surface, options, monitor);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const double used = static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC;
  Demand(report, "refine");
  rusage memory{};
  getrusage(RUSAGE_SELF, &memory);
  std::printf("%s: %zu -> %zu triangles, %.1f s (%.1f s of processors), %.2f GiB\n", path.c_str(),
              input.triangles.size(), surface.triangles.size(), seconds, used,
              static_cast<double>(memory.ru_maxrss) / (1 << 20));
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
  if (arguments.Get("measure", 1) > 0)
  {
    measures::Print(input, surface, options, voxel, arguments.Get("verbose", 0) > 0, monitor);
  }
  return 0;
}
