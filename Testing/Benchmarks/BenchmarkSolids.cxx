// SPDX-License-Identifier: BSD-3-Clause
// Layered Tetrahedra, and TetGen alone on the same closed surfaces with the same mean tet, in one run:
// BenchmarkSolids FILE SOLIDS program=PATH [NAME=VALUE]...
//
// FILE, SOLIDS and NAME as for MeasureSolids, and refined=1 for a surface that is; program: lamina-tetgen,
// which both use. TetGen gets the shape that Core Tetrahedra asks for and a largest volume; half as much
// again as the mean of our tets makes about as many.
#include "Geometry/Quality.h"
#include "SizedSurfaces.h"
#include "Surface/RefineSurface.h"
#include "Volume/ChildProcess.h"
#include "Volume/LayeredTets.h"
#include "Volume/TetGenRun.h"
#include "Volume/TetRegions.h"

#include <chrono>
#include <sstream>
#include <sys/resource.h>

using namespace lamina;

namespace
{

constexpr double largestOverMean = 1.5;
constexpr double poor = 0.1;

double PeakGiB(int who)
{
  rusage usage{};
  getrusage(who, &usage);
  return static_cast<double>(usage.ru_maxrss) / (1 << 20);
}

struct Measured
{
  double seconds = 0;
  std::size_t tets = 0;
  double least = 1;
  std::size_t belowGate = 0;

  void Add(double quality)
  {
    ++this->tets;
    this->least = std::min(this->least, quality);
    this->belowGate += quality <= poor ? 1 : 0;
  }
  void Print(const char* name, double memory) const
  {
    std::printf("| %s | %zu | %.1f | %.0f | %.2f | %.4f | %zu |\n", name, this->tets, this->seconds,
                static_cast<double>(this->tets) / this->seconds, memory, this->least, this->belowGate);
    std::fflush(stdout);
  }
};

template<typename Work>
double Seconds(Work&& work)
{
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The boundary of the solids, seen as one.
TriangleComplex BoundaryOf(const TriangleComplex& surface, const std::vector<int>& solids)
{
  TriangleComplex boundary;
  std::vector<Id> idOf(surface.points.size(), -1);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto isSolid = [&](int material)
    { return std::find(solids.begin(), solids.end(), material) != solids.end(); };
    const MaterialPair pair = surface.materials[t];
    if (!isSolid(pair.first) && !isSolid(pair.second))
    {
      continue;
    }
    Triangle corners = surface.triangles[t];
    for (Id& p : corners)
    {
      Id& id = idOf[static_cast<std::size_t>(p)];
      if (id < 0)
      {
        id = static_cast<Id>(boundary.points.size());
        boundary.points.push_back(surface.points[static_cast<std::size_t>(p)]);
      }
      p = id;
    }
    boundary.triangles.push_back(corners);
    boundary.materials.push_back(
      { isSolid(pair.first) ? pair.first : 0, isSolid(pair.second) ? pair.second : 0 });
  }
  return boundary;
}

Measured RunLayers(const TriangleComplex& surface, const LayeredTetsOptions& options, double& volume,
                   Monitor& monitor)
{
  VolumeMesh mesh;
  LayersOnSurface onSurface;
  Measured row;
  row.seconds = Seconds(
    [&]() { measures::Demand(MeshLayeredTets(surface, options, mesh, onSurface, monitor), "layers"); });
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    const auto p = PlacesOf<4>(mesh, c);
    row.Add(TetQuality(p[0], p[1], p[2], p[3]));
    volume += TetVolume(p[0], p[1], p[2], p[3]);
  }
  return row;
}

Measured RunTetGenAlone(const TriangleComplex& boundary, const std::string& program, double largest,
                        Monitor& monitor)
{
  TetGenTask task;
  task.points = boundary.points;
  task.facets = boundary.triangles;
  task.holes = FindHoles(boundary);
  char switches[64];
  std::snprintf(switches, sizeof switches, "Yq1.4a%.9g", largest);
  task.switches = switches;
  TetGenAnswer answer;
  Measured row;
  row.seconds = Seconds(
    [&]()
    {
      const auto bytes = RunChild(program, Encode(task), 1000, monitor);
      measures::Demand(bytes, "TetGen");
      answer = DecodeAnswer(*bytes).value_or(TetGenAnswer{ -1, "no answer", {}, {}, {} });
    });
  if (answer.code != 0)
  {
    std::printf("TetGen: %s\n", answer.message.c_str());
    std::exit(1);
  }
  for (const auto& tet : answer.tets)
  {
    const auto at = [&](std::size_t k) { return answer.points[static_cast<std::size_t>(tet[k])]; };
    row.Add(std::max(TetQuality(at(0), at(1), at(2), at(3)), TetQuality(at(0), at(1), at(3), at(2))));
  }
  return row;
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments(std::max(argc, 2), argv);
  if (argc < 4 || arguments.Text("program").empty())
  {
    std::printf("BenchmarkSolids FILE SOLIDS program=PATH [NAME=VALUE]...\n");
    return 1;
  }
  ThreadMonitor monitor(static_cast<int>(arguments.Get("threads", 2)));
  LayeredTetsOptions options;
  std::istringstream words(argv[2]);
  for (std::string word; std::getline(words, word, ',');)
  {
    options.materials.push_back(std::atoi(word.c_str()));
  }
  double voxel = 0;
  TriangleComplex surface = measures::Sized(argv[1], arguments, voxel, monitor);
  if (arguments.Get("refined", 0) == 0)
  {
    measures::Demand(RefineSurface(surface, {}, monitor), "refine");
  }
  options.layers = static_cast<int>(arguments.Get("layers", options.layers));
  options.anisotropy = arguments.Get("anisotropy", options.anisotropy);
  options.growth = arguments.Get("growth", options.growth);
  options.core.program = arguments.Text("program");
  std::printf("%s, %zu triangles, %d layers\n\n", argv[1], surface.triangles.size(), options.layers);
  std::printf("| | tets | seconds | tets a second | peak memory, GiB | least 3r/R | at most 0.1 |\n");
  std::printf("|---|---:|---:|---:|---:|---:|---:|\n");
  double volume = 0;
  const Measured layers = RunLayers(surface, options, volume, monitor);
  // Both processes at their peaks.
  layers.Print("Layered Tetrahedra", PeakGiB(RUSAGE_SELF) + PeakGiB(RUSAGE_CHILDREN));
  const double largest = largestOverMean * volume / static_cast<double>(layers.tets);
  const Measured alone =
    RunTetGenAlone(BoundaryOf(surface, options.materials), options.core.program, largest, monitor);
  alone.Print("TetGen alone", PeakGiB(RUSAGE_CHILDREN));
  return 0;
}
