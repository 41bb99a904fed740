// SPDX-License-Identifier: BSD-3-Clause
#include "AuditOverlap.h"

#include "../Geometry/CellLocation.h"
#include "Findings.h"
#include "SampleGrid.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <random>
#include <set>

namespace lamina
{
namespace
{

constexpr Id Grain = 4096;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

Location Locate(const VolumeMesh& mesh, Id cell, const Vec3& p)
{
  switch (mesh.types[Index(cell)])
  {
    case CellType::Wedge:
      return LocateInWedge(PlacesOf<6>(mesh, cell), p);
    case CellType::Pyramid:
      return LocateInPyramid(PlacesOf<5>(mesh, cell), p);
    default:
      return LocateInTet(PlacesOf<4>(mesh, cell), p);
  }
}

/// A number in [0, 1) from the generator's bits, the same on every machine.
double Unit(std::mt19937_64& generator)
{
  return static_cast<double>(generator() >> 11) * 0x1.0p-53;
}

std::vector<Sample> MakeSamples(const VolumeMesh& mesh, Id count, const Vec3& low, const Vec3& high)
{
  std::mt19937_64 generator(20240229);
  std::vector<Sample> samples;
  for (Id i = 0; i < count; ++i)
  {
    Vec3 inBox;
    for (int k = 0; k < 3; ++k)
    {
      inBox[k] = low[k] + Unit(generator) * (high[k] - low[k]);
    }
    samples.push_back({ inBox, Anything });
    // A mixture of a cell's nodes: inside it, or not far from it if its quads are bent.
    const Id cell = std::min(mesh.CellCount() - 1,
                             static_cast<Id>(Unit(generator) * static_cast<double>(mesh.CellCount())));
    const int nodes = NodeCount(mesh.types[Index(cell)]);
    Vec3 inCell;
    double sum = 0;
    for (int k = 0; k < nodes; ++k)
    {
      const double weight = 0.02 + Unit(generator);
      inCell += weight * mesh.points[Index(mesh.Cell(cell)[k])];
      sum += weight;
    }
    samples.push_back({ inCell * (1 / sum), Anything });
  }
  return samples;
}

/// The material of each sample by the surface's triangle next above it; left open where the way up grazes an
/// edge.
void AskSurface(const TriangleComplex& surface, double scale, const SampleGrid& grid, const Vec3& low,
                std::vector<Sample>& samples)
{
  std::vector<double> above(samples.size(), std::numeric_limits<double>::infinity());
  for (Sample& sample : samples)
  {
    sample.material = 0;
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    std::array<Vec3, 3> c;
    for (std::size_t k = 0; k < 3; ++k)
    {
      c[k] = surface.points[Index(surface.triangles[t][k])] * scale;
    }
    Vec3 from = c[0];
    Vec3 to = c[0];
    for (int k = 0; k < 3; ++k)
    {
      from[k] = std::min({ c[0][k], c[1][k], c[2][k] });
      to[k] = std::max({ c[0][k], c[1][k], c[2][k] });
    }
    from.z = low.z;
    const double area = (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x);
    grid.ForBox(from, to,
                [&](std::size_t i)
                {
                  const Vec3& p = samples[i].place;
                  double least = 1;
                  double z = 0;
                  for (std::size_t k = 0; k < 3 && area != 0; ++k)
                  {
                    const Vec3& a = c[(k + 1) % 3];
                    const Vec3& b = c[(k + 2) % 3];
                    const double weight = ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / area;
                    least = std::min(least, weight);
                    z += weight * c[k].z;
                  }
                  constexpr double graze = 1e-9;
                  if (area != 0 && least > -graze && z > p.z && z < above[i])
                  {
                    above[i] = z;
                    const MaterialPair pair = surface.materials[t];
                    samples[i].material = least < graze ? Anything : (area > 0 ? pair.first : pair.second);
                  }
                });
  }
}

/// How many cells hold each sample surely, and how many at all.
struct Holders
{
  explicit Holders(std::size_t count)
    : sure(count)
    , all(count)
    , wrong(count)
  {
  }
  std::vector<std::atomic<int>> sure;
  std::vector<std::atomic<int>> all;
  std::vector<std::atomic<int>> wrong; ///< sure ones of another material than the surface says
};

template<typename Visit>
void ForHolders(const VolumeMesh& mesh, const std::vector<Sample>& samples, const SampleGrid& grid,
                Monitor& monitor, Visit&& visit)
{
  monitor.For(mesh.CellCount(), Grain,
              [&](Id begin, Id end)
              {
                for (Id cell = begin; cell < end; ++cell)
                {
                  const Id* nodes = mesh.Cell(cell);
                  Vec3 low = mesh.points[Index(nodes[0])];
                  Vec3 high = low;
                  for (int n = 1; n < NodeCount(mesh.types[Index(cell)]); ++n)
                  {
                    const Vec3& p = mesh.points[Index(nodes[n])];
                    low = { std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z) };
                    high = { std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z) };
                  }
                  grid.ForBox(low, high,
                              [&](std::size_t i)
                              {
                                const Location location = Locate(mesh, cell, samples[i].place);
                                if (location != Location::Outside)
                                {
                                  visit(cell, i, location);
                                }
                              });
                }
              });
}

} // namespace

void AuditOverlap(const VolumeMesh& mesh, const TriangleComplex* surface, const AuditOptions& options,
                  AuditReport& report, AuditMarks& marks, Monitor& monitor)
{
  if (mesh.CellCount() == 0 || options.overlapSamples <= 0)
  {
    return;
  }
  Vec3 low = mesh.points[Index(mesh.connectivity[0])];
  Vec3 high = low;
  for (Id p : mesh.connectivity)
  {
    const Vec3& q = mesh.points[Index(p)];
    low = { std::min(low.x, q.x), std::min(low.y, q.y), std::min(low.z, q.z) };
    high = { std::max(high.x, q.x), std::max(high.y, q.y), std::max(high.z, q.z) };
  }
  auto samples = MakeSamples(mesh, options.overlapSamples, low, high);
  const SampleGrid grid(samples, low, high);
  std::set<int> meshed(mesh.materials.begin(), mesh.materials.end());
  if (surface != nullptr)
  {
    AskSurface(*surface, options.surfaceScale, grid, low, samples);
  }
  Holders holders(samples.size());
  ForHolders(mesh, samples, grid, monitor,
             [&](Id cell, std::size_t i, Location location)
             {
               const bool isWrong =
                 samples[i].material != Anything && mesh.materials[Index(cell)] != samples[i].material;
               ++holders.all[i];
               holders.sure[i] += location == Location::Inside;
               holders.wrong[i] += location == Location::Inside && isWrong;
             });
  Places crowded;
  Places empty;
  Places wrong;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const bool isDue = samples[i].material != Anything && meshed.count(samples[i].material) != 0;
    if (holders.sure[i] > 1)
    {
      crowded.Add(samples[i].place);
    }
    else if (isDue && holders.all[i] == 0)
    {
      empty.Add(samples[i].place);
    }
    else if (holders.wrong[i] > 0)
    {
      wrong.Add(samples[i].place);
    }
  }
  report.overlaps = crowded.GetCount() + empty.GetCount() + wrong.GetCount();
  crowded.Tell("sample points lie in more than one cell", report.findings);
  empty.Tell("sample points inside the surface lie in no cell", report.findings);
  wrong.Tell("sample points lie in a cell of another material than the surface says", report.findings);
  if (crowded.GetCount() + wrong.GetCount() > 0)
  {
    // A cell is written by one thread only.
    ForHolders(mesh, samples, grid, monitor,
               [&](Id cell, std::size_t i, Location location)
               {
                 const bool isBad = holders.sure[i] > 1 || holders.wrong[i] > 0;
                 marks.flags[Index(cell)] |= isBad && location == Location::Inside ? FlagOverlap : 0;
               });
  }
}

} // namespace lamina
