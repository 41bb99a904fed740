// SPDX-License-Identifier: BSD-3-Clause
#include "ClusterPoints.h"

#include "../Search/TriangleTree.h"
#include "EditableSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

namespace lamina
{

namespace
{

constexpr int mostRounds = 4;

/// Nothing corrects volumes afterwards: what is missing is booked and given back by smoothing.
constexpr double shareOfTolerance = 0.8;

std::size_t At(Id i)
{
  return static_cast<std::size_t>(i);
}

double AreaOf(const TriangleComplex& surface, std::size_t t)
{
  return 0.5 * Norm(AreaVector2(surface.points, surface.triangles[t]));
}

struct ShortEdge
{
  double length;
  std::array<Id, 2> ends;

  bool operator<(const ShortEdge& other) const
  {
    return this->length != other.length ? this->length < other.length : this->ends < other.ends;
  }
};

std::vector<ShortEdge> FindShortEdges(const EditableSurface& surface, double length)
{
  std::vector<ShortEdge> edges;
  for (Id t = 0; t < surface.TriangleCount(); ++t)
  {
    for (std::size_t k = 0; k < 3 && surface.IsAlive(t); ++k)
    {
      const Id a = surface.Corners(t)[k];
      const Id b = surface.Corners(t)[(k + 1) % 3];
      const double now = surface.Length(a, b);
      if (now < length)
      {
        edges.push_back({ now, { { std::min(a, b), std::max(a, b) } } });
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  const auto same = [](const ShortEdge& a, const ShortEdge& b) { return a.ends == b.ends; };
  edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());
  return edges;
}

/// Merges what can be merged; the number of merges.
Id MergeShortEdges(EditableSurface& surface, double length, Monitor& monitor)
{
  Id merged = 0;
  Id before = -1;
  for (int round = 0; round < mostRounds && merged != before && !monitor.Cancelled(); ++round)
  {
    before = merged;
    const std::vector<ShortEdge> edges = FindShortEdges(surface, length);
    for (std::size_t e = 0; e < edges.size() && (e % 1024 != 0 || !monitor.Cancelled()); ++e)
    {
      const auto& ends = edges[e].ends;
      // An earlier merge may have taken or moved an end.
      const bool isThere = surface.TrianglesAt(ends[0], ends[1]).size() > 0;
      const bool isShort = isThere && surface.Length(ends[0], ends[1]) < length;
      merged += isShort && surface.Merge(ends[0], ends[1], true) ? 1 : 0;
    }
  }
  return merged;
}

/// The trees of the triangles of each pair of materials, with their ids.
class PairTrees
{
public:
  explicit PairTrees(const TriangleComplex& surface)
  {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      this->Parts[surface.materials[t]].push_back(surface.triangles[t]);
      this->Ids[surface.materials[t]].push_back(static_cast<Id>(t));
    }
    for (const auto& [pair, triangles] : this->Parts)
    {
      this->Trees[pair] = std::make_unique<TriangleTree>(surface.points, triangles);
    }
  }
  /// The triangle of the pair that is nearest to p, -1 if the pair has none.
  Id Nearest(const MaterialPair& pair, const Vec3& p) const
  {
    const auto tree = this->Trees.find(pair);
    if (tree == this->Trees.end())
    {
      return -1;
    }
    const auto found = tree->second->ClosestPoint(p);
    return found.triangle < 0 ? -1 : this->Ids.at(pair)[At(found.triangle)];
  }

private:
  std::map<MaterialPair, std::vector<Triangle>> Parts; ///< the trees look at them
  std::map<MaterialPair, std::unique_ptr<TriangleTree>> Trees;
  std::map<MaterialPair, std::vector<Id>> Ids;
};

/// What the old triangles lack, handed to the nearest new ones.
void CarryMissing(const TriangleComplex& old, TriangleComplex& now)
{
  const PairTrees trees(now);
  std::vector<std::array<double, 2>> volumes(now.triangles.size(), { { 0, 0 } });
  for (std::size_t t = 0; t < old.missing.size(); ++t)
  {
    if (old.missing[t][0] == 0 && old.missing[t][1] == 0)
    {
      continue;
    }
    Vec3 middle;
    for (const Id p : old.triangles[t])
    {
      middle += (1.0 / 3) * old.points[At(p)];
    }
    const Id nearest = trees.Nearest(old.materials[t], middle);
    const double area = AreaOf(old, t);
    for (std::size_t side = 0; side < 2 && nearest >= 0; ++side)
    {
      volumes[At(nearest)][side] += old.missing[t][side] * area * std::sqrt(area);
    }
  }
  now.missing.assign(now.triangles.size(), { { 0, 0 } });
  for (std::size_t t = 0; t < volumes.size(); ++t)
  {
    const double area = AreaOf(now, t);
    now.missing[t] = { { volumes[t][0] / (area * std::sqrt(area)),
                         volumes[t][1] / (area * std::sqrt(area)) } };
  }
}

/// What the merges changed, shell by shell, spread evenly over each.
void BookChange(const TriangleComplex& old, const SheetGraph& oldSheets, const SheetGraph& sheets,
                TriangleComplex& now)
{
  std::vector<double> lacks = ShellVolumes(old, oldSheets);
  const std::vector<double> volumes = ShellVolumes(now, sheets);
  std::vector<double> areas(lacks.size(), 0);
  const auto shellsOf = [&](std::size_t t) -> const auto&
  {
    return sheets.shellsOfSheet[At(sheets.sheetOfTriangle[t])];
  };
  for (std::size_t t = 0; t < now.triangles.size(); ++t)
  {
    for (const int shell : shellsOf(t))
    {
      if (shell >= 0)
      {
        areas[At(shell)] += AreaOf(now, t);
      }
    }
  }
  for (std::size_t s = 0; s < lacks.size(); ++s)
  {
    lacks[s] = areas[s] > 0 ? (lacks[s] - volumes[s]) / areas[s] : 0;
  }
  for (std::size_t t = 0; t < now.triangles.size(); ++t)
  {
    const auto& shells = shellsOf(t);
    const double root = std::sqrt(AreaOf(now, t));
    for (std::size_t side = 0; side < 2; ++side)
    {
      // Background has no shell: it gives what its neighbour gains.
      const double lack = shells[side] >= 0 ? lacks[At(shells[side])] : -lacks[At(shells[1 - side])];
      now.missing[t][side] += lack / root;
    }
  }
}

} // namespace

Id ClusterPoints(TriangleComplex& surface, double length, double tolerance, Monitor& monitor)
{
  const double length2 = length * length;
  const bool hasShort = std::any_of(
    surface.triangles.begin(), surface.triangles.end(),
    [&](const Triangle& t)
    {
      const auto x = [&](std::size_t k) { return surface.points[At(t[k % 3])]; };
      return Norm2(x(1) - x(0)) < length2 || Norm2(x(2) - x(1)) < length2 || Norm2(x(0) - x(2)) < length2;
    });
  if (!hasShort)
  {
    return 0;
  }
  TriangleComplex old = surface;
  old.targetEdgeLength.assign(old.points.size(), length);
  const InputSurface input(old, tolerance, 1, monitor, shareOfTolerance);
  EditableSurface editable(input, 1, 2);
  const Id merged = MergeShortEdges(editable, length, monitor);
  TriangleComplex now = old;
  editable.Write(now, monitor);
  now.targetEdgeLength.clear();
  CarryMissing(old, now);
  BookChange(old, input.Sheets(), editable.WrittenSheets(), now);
  if (monitor.Cancelled())
  {
    return 0;
  }
  surface = std::move(now);
  return merged;
}

} // namespace lamina
