// SPDX-License-Identifier: BSD-3-Clause
#include "RefineSurface.h"

#include "../Geometry/Quality.h"
#include "../Geometry/VisibleDirection.h"
#include "../Mesh/Closedness.h"
#include "../Search/SelfIntersection.h"
#include "EditableSurface.h"

#include <algorithm>
#include <queue>

namespace lamina
{

namespace
{

struct RankedEdge
{
  double rank;
  Id a;
  Id b;
};
/// The top of the queue is the highest rank; ties go to the lower ids, so that the order is always the same.
struct Before
{
  bool operator()(const RankedEdge& e, const RankedEdge& f) const
  {
    return e.rank != f.rank ? e.rank < f.rank : (e.a != f.a ? e.a > f.a : e.b > f.b);
  }
};
using EdgeQueue = std::priority_queue<RankedEdge, std::vector<RankedEdge>, Before>;

constexpr Id cancelStride = 4096;

class Refinement
{
public:
  Refinement(EditableSurface& surface, const RefineSurfaceOptions& options, Monitor& monitor)
    : Surface(surface)
    , Options(options)
    , Watch(monitor)
  {
  }
  bool Iterate(RefineSurfaceReport& report);
  void MendShapes(RefineSurfaceReport& report);
  void UncoverNodes();

private:
  template<typename Visit>
  void ForEdges(Visit&& visit) const;
  void SplitLong(RefineSurfaceReport& report);
  void SplitAlongPath(Id a, Id b, EdgeQueue& queue, RefineSurfaceReport& report);
  void MergeShort(RefineSurfaceReport& report);
  void SwapAll(RefineSurfaceReport& report);
  void RelaxAll();
  bool Stopped() { return ++this->Ticks % cancelStride == 0 && this->Watch.Cancelled(); }

  EditableSurface& Surface;
  const RefineSurfaceOptions& Options;
  Monitor& Watch;
  Id Ticks = 0;
};

template<typename Visit>
void Refinement::ForEdges(Visit&& visit) const
{
  for (Id t = 0; t < this->Surface.TriangleCount(); ++t)
  {
    if (!this->Surface.IsAlive(t))
    {
      continue;
    }
    const Triangle corners = this->Surface.Corners(t);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id a = corners[k];
      const Id b = corners[(k + 1) % 3];
      // Each edge once: from the triangle with the least id.
      const std::vector<Id> at = this->Surface.TrianglesAt(a, b);
      if (!at.empty() && *std::min_element(at.begin(), at.end()) == t)
      {
        visit(std::min(a, b), std::max(a, b));
      }
    }
  }
}

void Refinement::SplitLong(RefineSurfaceReport& report)
{
  EdgeQueue queue;
  this->ForEdges(
    [&](Id a, Id b)
    {
      const double r = this->Surface.RelativeLength(a, b);
      if (r > this->Options.splitRatio)
      {
        queue.push({ r, a, b });
      }
    });
  while (!queue.empty() && !this->Stopped())
  {
    const RankedEdge edge = queue.top();
    queue.pop();
    if (!this->Surface.TrianglesAt(edge.a, edge.b).empty())
    {
      this->SplitAlongPath(edge.a, edge.b, queue, report);
    }
  }
}

/// Rivara's longest-edge path: an edge is bisected only when it is the longest of all its triangles; before
/// that the longer ones are, so that no angle falls below half of what it was.
void Refinement::SplitAlongPath(Id a, Id b, EdgeQueue& queue, RefineSurfaceReport& report)
{
  Id u = a;
  Id v = b;
  for (bool longer = true; longer;)
  {
    longer = false;
    double longest = this->Surface.Length(u, v) * (1 + 1e-9);
    for (Id t : this->Surface.TrianglesAt(u, v))
    {
      const Triangle c = this->Surface.Corners(t);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Id p = std::min(c[k], c[(k + 1) % 3]);
        const Id q = std::max(c[k], c[(k + 1) % 3]);
        if (this->Surface.Length(p, q) > longest)
        {
          longest = this->Surface.Length(p, q) * (1 + 1e-9);
          u = p;
          v = q;
          longer = true;
        }
      }
    }
  }
  const Id middle = this->Surface.Split(u, v);
  ++report.splits;
  std::vector<Id> ends;
  for (Id t : this->Surface.Star(middle))
  {
    for (Id p : this->Surface.Corners(t))
    {
      if (p != middle)
      {
        ends.push_back(p);
      }
    }
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (Id p : ends)
  {
    const double r = this->Surface.RelativeLength(p, middle);
    if (r > this->Options.splitRatio)
    {
      queue.push({ r, std::min(p, middle), std::max(p, middle) });
    }
  }
  if (!(u == a && v == b))
  {
    queue.push({ this->Surface.RelativeLength(a, b), a, b }); // its turn comes again
  }
}

void Refinement::MergeShort(RefineSurfaceReport& report)
{
  EdgeQueue queue; // the highest rank first: the shortest edge
  const auto offer = [&](Id a, Id b)
  {
    const double r = this->Surface.RelativeLength(a, b);
    if (r < this->Options.mergeRatio)
    {
      queue.push({ -r, std::min(a, b), std::max(a, b) });
    }
  };
  this->ForEdges(offer);
  while (!queue.empty() && !this->Stopped())
  {
    const RankedEdge edge = queue.top();
    queue.pop();
    if (this->Surface.TrianglesAt(edge.a, edge.b).empty() ||
        this->Surface.RelativeLength(edge.a, edge.b) >= this->Options.mergeRatio ||
        !this->Surface.Merge(edge.a, edge.b))
    {
      continue;
    }
    ++report.merges;
    const Id kept = this->Surface.Star(edge.a).empty() ? edge.b : edge.a;
    std::vector<Id> ends;
    for (Id t : this->Surface.Star(kept))
    {
      const Triangle& c = this->Surface.Corners(t);
      ends.insert(ends.end(), c.begin(), c.end());
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for (Id p : ends)
    {
      if (p != kept)
      {
        offer(kept, p);
      }
    }
  }
}

void Refinement::SwapAll(RefineSurfaceReport& report)
{
  for (int pass = 0; pass < 4; ++pass)
  {
    std::vector<std::pair<Id, Id>> edges;
    this->ForEdges([&](Id a, Id b) { edges.push_back({ a, b }); });
    Id swapped = 0;
    for (const auto& edge : edges)
    {
      if (this->Stopped())
      {
        return;
      }
      swapped += this->Surface.TrianglesAt(edge.first, edge.second).size() == 2 &&
                     this->Surface.Swap(edge.first, edge.second)
                   ? 1
                   : 0;
    }
    report.swaps += swapped;
    if (swapped * 200 < static_cast<Id>(edges.size()))
    {
      break;
    }
  }
}

void Refinement::RelaxAll()
{
  for (Id p = 0; p < this->Surface.PointCount() && !this->Stopped(); ++p)
  {
    this->Surface.Relax(p);
  }
}

bool Refinement::Iterate(RefineSurfaceReport& report)
{
  this->MergeShort(report);
  this->SplitLong(report);
  this->SwapAll(report);
  this->RelaxAll();
  this->SwapAll(report);
  this->RelaxAll();
  return !this->Watch.Cancelled();
}

/// Nodes whose faces no direction sees well: nothing good can grow there.
void Refinement::UncoverNodes()
{
  constexpr double goal = 0.5;
  for (int round = 0; round < 8; ++round)
  {
    std::vector<std::pair<double, Id>> hidden;
    for (Id p = 0; p < this->Surface.PointCount(); ++p)
    {
      const double sight = this->Surface.Star(p).empty() ? 1 : this->Surface.Visibility(p);
      if (sight < goal)
      {
        hidden.push_back({ sight, p });
      }
    }
    std::sort(hidden.begin(), hidden.end());
    Id mended = 0;
    for (const auto& node : hidden)
    {
      for (int again = 0; again < 4 && !this->Stopped() && this->Surface.Uncover(node.second, goal); ++again)
      {
        ++mended;
      }
    }
    if (mended == 0)
    {
      return;
    }
  }
}

/// Bad triangles that the rounds left: merge away their shortest edge or move a corner.
void Refinement::MendShapes(RefineSurfaceReport& report)
{
  constexpr double good = 0.4;
  for (int round = 0; round < 4; ++round)
  {
    std::vector<std::pair<double, Id>> bad;
    for (Id t = 0; t < this->Surface.TriangleCount(); ++t)
    {
      if (this->Surface.IsAlive(t) && this->Surface.Quality(t) < good)
      {
        bad.push_back({ this->Surface.Quality(t), t });
      }
    }
    if (bad.empty() || this->Watch.Cancelled())
    {
      return;
    }
    std::sort(bad.begin(), bad.end());
    for (const auto& item : bad)
    {
      if (!this->Surface.IsAlive(item.second) || this->Surface.Quality(item.second) > good || this->Stopped())
      {
        continue;
      }
      Triangle c = this->Surface.Corners(item.second);
      std::size_t shortest = 0;
      for (std::size_t k = 1; k < 3; ++k)
      {
        if (this->Surface.Length(c[k], c[(k + 1) % 3]) <
            this->Surface.Length(c[shortest], c[(shortest + 1) % 3]))
        {
          shortest = k;
        }
      }
      const bool merged = this->Surface.Merge(c[shortest], c[(shortest + 1) % 3], true) ||
                          this->Surface.Merge(c[(shortest + 1) % 3], c[(shortest + 2) % 3], true) ||
                          this->Surface.Merge(c[(shortest + 2) % 3], c[shortest], true);
      report.merges += merged ? 1 : 0;
    }
    this->SwapAll(report);
    for (const auto& item : bad)
    {
      if (this->Surface.IsAlive(item.second))
      {
        for (Id p : Triangle(this->Surface.Corners(item.second)))
        {
          this->Surface.Relax(p);
        }
      }
    }
  }
}

Result<RefineSurfaceReport> Check(const TriangleComplex& surface, const RefineSurfaceOptions& options,
                                  Monitor& monitor)
{
  if (options.iterations < 1)
  {
    return InvalidOption("the number of iterations must be 1 or more, not " +
                         std::to_string(options.iterations));
  }
  if (!(options.splitRatio > 1) || !(options.mergeRatio > 0) || !(options.mergeRatio < 1))
  {
    return InvalidOption("the split ratio must be above 1 and the merge ratio between 0 and 1");
  }
  if (!(options.tolerance >= 0))
  {
    return InvalidOption("the tolerance must be positive, or 0 for a tenth of the feature size");
  }
  if (const std::optional<Error> error = CheckClosed(surface, true, monitor))
  {
    return *error;
  }
  if (surface.targetEdgeLength.size() != surface.points.size())
  {
    return InvalidInput("there is no target edge length on the points: run Feature Size first, or give an "
                        "array TargetEdgeLength");
  }
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    if (!(surface.targetEdgeLength[p] > 0) || !std::isfinite(surface.targetEdgeLength[p]))
    {
      return InvalidInput("the target edge length of point " + std::to_string(p) + " is " +
                            std::to_string(surface.targetEdgeLength[p]) + ": it must be positive and finite",
                          { surface.points[p] });
    }
  }
  return RefineSurfaceReport{};
}

/// The correction moves points a little: where that makes triangles meet, their points are left out of it.
void RestoreWithoutIntersections(TriangleComplex& surface, const SheetGraph& sheets,
                                 const std::vector<double>& targets, Monitor& monitor)
{
  const std::vector<Vec3> start = surface.points;
  std::vector<char> frozen(surface.points.size(), 0);
  const Lists star = TrianglesOfPoints(static_cast<Id>(start.size()), surface.triangles);
  for (int round = 0; round < 8; ++round)
  {
    RestoreVolumes(surface, sheets, targets, frozen);
    const auto pairs = FindIntersections(surface.points, surface.triangles, monitor);
    if (pairs.empty())
    {
      return;
    }
    surface.points = start;
    for (const auto& pair : pairs)
    {
      for (Id t : pair)
      {
        for (Id p : surface.triangles[static_cast<std::size_t>(t)])
        {
          for (Id near : Row(star, p))
          {
            for (Id q : surface.triangles[static_cast<std::size_t>(near)])
            {
              frozen[static_cast<std::size_t>(q)] = 1;
            }
          }
        }
      }
    }
  }
  // Better a small error of volume, which the report tells, than an intersection.
}

void Measure(const TriangleComplex& surface, RefineSurfaceReport& report)
{
  report.triangles = static_cast<Id>(surface.triangles.size());
  report.leastQuality = 1;
  Id inRange = 0;
  Id edges = 0;
  for (const Triangle& t : surface.triangles)
  {
    const auto at = [&](std::size_t k) { return surface.points[static_cast<std::size_t>(t[k % 3])]; };
    report.leastQuality = std::min(report.leastQuality, TriangleQuality(at(0), at(1), at(2)));
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double h = 0.5 * (surface.targetEdgeLength[static_cast<std::size_t>(t[k])] +
                              surface.targetEdgeLength[static_cast<std::size_t>(t[(k + 1) % 3])]);
      const double r = Norm(at(k) - at(k + 1)) / h;
      ++edges;
      inRange += r >= 0.5 && r <= 1.5 ? 1 : 0;
    }
  }
  report.edgesInRange = edges > 0 ? static_cast<double>(inRange) / static_cast<double>(edges) : 1;
  const Lists star = TrianglesOfPoints(static_cast<Id>(surface.points.size()), surface.triangles);
  const std::vector<int> materials = MaterialsOf(surface);
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    for (int material : materials)
    {
      std::vector<Vec3> normals;
      for (Id t : Row(star, static_cast<Id>(p)))
      {
        const int side = SideOf(surface.materials[static_cast<std::size_t>(t)], material);
        if (side != 0)
        {
          normals.push_back(
            side * Normalized(AreaVector2(surface.points, surface.triangles[static_cast<std::size_t>(t)])));
        }
      }
      if (!normals.empty() && FindVisibleDirection(normals).leastCosine < 0.4)
      {
        ++report.hiddenNodes;
        report.hiddenPlaces.push_back(surface.points[p]);
        break;
      }
    }
  }
}

} // namespace

Result<RefineSurfaceReport> RefineSurface(TriangleComplex& surface, const RefineSurfaceOptions& options,
                                          Monitor& monitor)
{
  Result<RefineSurfaceReport> checked = Check(surface, options, monitor);
  if (!checked)
  {
    return checked.GetError();
  }
  if (const auto error = CheckEmbedded(surface.points, surface.triangles, "the surface to refine", monitor))
  {
    return *error;
  }
  RefineSurfaceReport report;
  if (surface.triangles.empty())
  {
    return report;
  }
  if (surface.junctionKind.size() != surface.points.size())
  {
    ClassifyJunctions(surface);
  }
  const std::vector<int> materials = MaterialsOf(surface);
  const std::vector<double> before = MaterialVolumes(surface, materials);
  const InputSurface input(surface, options.tolerance);
  const std::vector<double> targets = ShellVolumes(surface, input.Sheets());
  EditableSurface editable(input, options.mergeRatio, options.splitRatio);
  Refinement refinement(editable, options, monitor);
  for (int i = 0; i < options.iterations; ++i)
  {
    monitor.Progress(static_cast<double>(i) / (options.iterations + 1), "refining");
    if (!refinement.Iterate(report))
    {
      return Cancelled();
    }
  }
  refinement.MendShapes(report);
  refinement.UncoverNodes();
  refinement.MendShapes(report);
  monitor.Progress(0.95, "restoring volumes");
  TriangleComplex refined;
  editable.Write(refined);
  RestoreWithoutIntersections(refined, editable.WrittenSheets(), targets, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  surface = std::move(refined);
  const std::vector<double> after = MaterialVolumes(surface, materials);
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    report.largestVolumeChange =
      std::max(report.largestVolumeChange, std::abs(after[m] - before[m]) / std::abs(before[m]));
  }
  Measure(surface, report);
  monitor.Progress(1, "refined");
  return report;
}

} // namespace lamina
