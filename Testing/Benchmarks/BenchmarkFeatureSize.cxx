// SPDX-License-Identifier: BSD-3-Clause
// How long the feature size takes, stage by stage: BenchmarkFeatureSize [THREADS [EDGE]]. The surface is a
// tree of shells: bumpy tori of tissue around tori of blood, about a million triangles with the default edge.
#include "GapMonitor.h"
#include "Shapes.h"
#include "Sizing/Curvature.h"
#include "Sizing/FeatureSize.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace lamina;

namespace
{

/// Says when each stage begins: wall clock and processor time since the start.
class TellingMonitor : public GapMonitor
{
public:
  using GapMonitor::GapMonitor;
  void Progress(double part, const char* what) override
  {
    this->GapMonitor::Progress(part, what);
    using Clock = std::chrono::steady_clock;
    const double wall = std::chrono::duration<double>(Clock::now() - this->Start).count();
    const double user = static_cast<double>(std::clock() - this->Used) / CLOCKS_PER_SEC;
    std::printf("%8.2f s wall, %8.2f s of all threads: %s\n", wall, user, what);
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
  std::clock_t Used = std::clock();
};

} // namespace

int main(int argc, char** argv)
{
  const int threads = argc > 1 ? std::atoi(argv[1]) : 2;
  const double edge = argc > 2 ? std::atof(argv[2]) : 0.0239;
  TriangleComplex surface;
  shapes::AddTorus(surface, 3, 1, edge, 0.2, { 1, 2 });
  shapes::AddTorus(surface, 3, 1.3, edge, 0.2, { 2, 0 });
  // Roughness as smoothed voxels leave it: a few edges long, a part of an edge high.
  for (Vec3& p : surface.points)
  {
    const double wave = 2 / edge;
    p += 0.1 * edge * Vec3{ std::sin(wave * p.y), std::sin(wave * p.z), std::sin(wave * p.x) };
  }
  std::printf("%zu triangles, %zu points, %d threads\n", surface.triangles.size(), surface.points.size(),
              threads);
  TellingMonitor monitor(threads);
  const auto report = ComputeFeatureSize(surface, {}, monitor);
  if (!report)
  {
    std::printf("%s\n", report.GetError().message.c_str());
    return 1;
  }
  std::printf("longest without a question whether to stop: %.2f s of processors (%s)\n", monitor.Longest(),
              monitor.Where().c_str());
  std::printf("sizes from %g to %g, %lld points curved\n", report->leastSize, report->largestSize,
              report->curved);
  return 0;
}
