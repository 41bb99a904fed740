// SPDX-License-Identifier: BSD-3-Clause
// How well a segmentation of the phantom heart agrees with the truth.
#pragma once

#include "Segmentation/ConnectedComponents.h"
#include "Segmentation/HeartPhantom.h"
#include "Segmentation/Segment.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace lamina::scores
{

struct Phantom
{
  GreyImage grey;
  LabelImage truth;
  HeartPhantomReport report;
};

inline double Dice(Id both, Id first, Id second)
{
  return first + second > 0 ? 2.0 * both / static_cast<double>(first + second) : 1.0;
}

/// Overlap of one material.
inline double DiceOf(const Phantom& phantom, const LabelImage& found, int material)
{
  Id both = 0;
  Id first = 0;
  Id second = 0;
  for (std::size_t v = 0; v < found.labels.size(); ++v)
  {
    const bool a = phantom.truth.labels[v] == material;
    const bool b = found.labels[v] == material;
    both += a && b;
    first += a;
    second += b;
  }
  return Dice(both, first, second);
}

inline double DistanceTo(const HeartPhantomRod& rod, const Vec3& p)
{
  const Vec3 axis = rod.to - rod.from;
  const double t = std::min(1.0, std::max(0.0, Dot(p - rod.from, axis) / std::max(Norm2(axis), 1e-12)));
  const double diameter = rod.fromDiameter + t * (rod.toDiameter - rod.fromDiameter);
  return Norm(p - rod.from - axis * t) - 0.5 * diameter;
}

inline std::array<Id, 3> PlaceOf(const GridGeometry& grid, Id v)
{
  return { v % grid.size[0], v / grid.size[0] % grid.size[1], v / (grid.size[0] * grid.size[1]) };
}

/// Call visit(voxel, centre) for the voxels whose distance to a rod's surface is below `reach`.
template<typename Visit>
void ForEachVoxelNear(const GridGeometry& grid, const HeartPhantomRod& rod, double reach, const Visit& visit)
{
  const double far = reach + 0.5 * std::max(rod.fromDiameter, rod.toDiameter);
  Id from[3];
  Id to[3];
  for (int a = 0; a < 3; ++a)
  {
    from[a] = std::max<Id>(0, static_cast<Id>(std::floor(std::min(rod.from[a], rod.to[a]) - far)));
    to[a] =
      std::min<Id>(grid.size[a] - 1, static_cast<Id>(std::ceil(std::max(rod.from[a], rod.to[a]) + far)));
  }
  for (Id k = from[2]; k <= to[2]; ++k)
  {
    for (Id j = from[1]; j <= to[1]; ++j)
    {
      for (Id i = from[0]; i <= to[0]; ++i)
      {
        const Vec3 p{ double(i), double(j), double(k) };
        if (DistanceTo(rod, p) < reach)
        {
          visit(grid.Index(i, j, k), p);
        }
      }
    }
  }
}

/// Overlap of coronaries (in blood) or strands (in tissue), counted within two voxels of rods no thicker than
/// `thickest` voxels; what truly is another part of the same material does not count.
inline double DiceOfRods(const Phantom& phantom, const LabelImage& found, HeartPart part, double thickest)
{
  const bool coronary = part == HeartPart::Coronary;
  const int material = coronary ? Blood : Tissue;
  std::vector<unsigned char> near(found.labels.size(), 0);
  for (const HeartPhantomRod& rod : coronary ? phantom.report.coronaries : phantom.report.strands)
  {
    if (std::max(rod.fromDiameter, rod.toDiameter) <= thickest)
    {
      ForEachVoxelNear(found.grid, rod, 2, [&](Id v, const Vec3&) { near[v] = 1; });
    }
  }
  Id both = 0;
  Id first = 0;
  Id second = 0;
  for (std::size_t v = 0; v < near.size(); ++v)
  {
    const bool other = phantom.truth.labels[v] == material && phantom.report.parts[v] != part;
    if (near[v] && !other)
    {
      const bool a = phantom.report.parts[v] == part;
      const bool b = found.labels[v] == material;
      both += a && b;
      first += a;
      second += b;
    }
  }
  return Dice(both, first, second);
}

/// The component of a voxel.
inline int ComponentAt(const ComponentMap& map, Id voxel)
{
  const Id row = voxel / map.size[0];
  const int i = static_cast<int>(voxel % map.size[0]);
  const auto from = map.runs.begin() + map.rowStart[row];
  const auto to = map.runs.begin() + map.rowStart[row + 1];
  const auto run = std::upper_bound(from, to, i, [](int a, const LabelRun& r) { return a < r.end; });
  return run->component;
}

/// The vessels (chains of rods) of which a place at least `least` voxels wide is not joined to the root
/// within the blood, and the number of all vessels.
inline std::pair<int, int> BrokenCoronaries(const Phantom& phantom, const LabelImage& found, double least)
{
  ThreadMonitor monitor(2);
  const ComponentMap map = FindComponents(found.labels, found.grid.size, Connectivity::Faces, monitor);
  int broken = 0;
  int vessels = 0;
  const auto& rods = phantom.report.coronaries;
  for (std::size_t r = 0; r < rods.size();)
  {
    int root = -1;
    bool whole = true;
    std::size_t end = r;
    for (; end < rods.size() && (end == r || Norm(rods[end].from - rods[end - 1].to) < 1e-9); ++end)
    {
      const HeartPhantomRod& rod = rods[end];
      const int steps = static_cast<int>(std::ceil(2 * Norm(rod.to - rod.from)));
      for (int s = 0; s <= steps; ++s)
      {
        const double t = double(s) / std::max(steps, 1);
        if (rod.fromDiameter + t * (rod.toDiameter - rod.fromDiameter) < least)
        {
          continue;
        }
        const Vec3 p = rod.from + (rod.to - rod.from) * t;
        const Id v = found.grid.Index(std::lround(p.x), std::lround(p.y), std::lround(p.z));
        const int component = found.labels[v] == Blood ? ComponentAt(map, v) : -1;
        root = root < 0 && s == 0 && end == r ? component : root;
        whole = whole && component >= 0 && component == root;
      }
    }
    broken += !whole;
    ++vessels;
    r = end;
  }
  return { broken, vessels };
}

/// Strands that do not join their two ends through tissue near them, and the number of all.
inline std::pair<int, int> BrokenStrands(const Phantom& phantom, const LabelImage& found)
{
  int broken = 0;
  for (const HeartPhantomRod& rod : phantom.report.strands)
  {
    std::vector<Id> tube;
    ForEachVoxelNear(found.grid, rod, 1.5,
                     [&](Id v, const Vec3&)
                     {
                       if (found.labels[v] == Tissue)
                       {
                         tube.push_back(v);
                       }
                     });
    const auto distance = [&](Id v, const Vec3& end)
    {
      const auto p = PlaceOf(found.grid, v);
      return Norm(Vec3{ double(p[0]), double(p[1]), double(p[2]) } - end);
    };
    std::sort(tube.begin(), tube.end());
    std::vector<unsigned char> seen(tube.size(), 0);
    std::vector<Id> stack;
    for (std::size_t n = 0; n < tube.size(); ++n)
    {
      if (distance(tube[n], rod.from) < 0.5 * rod.fromDiameter + 1)
      {
        seen[n] = 1;
        stack.push_back(tube[n]);
      }
    }
    bool joined = false;
    const auto& size = found.grid.size;
    while (!stack.empty() && !joined)
    {
      const Id v = stack.back();
      stack.pop_back();
      joined = distance(v, rod.to) < 0.5 * rod.toDiameter + 1;
      for (const Id step : { Id{ 1 }, size[0], size[0] * size[1] })
      {
        for (const Id w : { v - step, v + step })
        {
          const auto at = std::lower_bound(tube.begin(), tube.end(), w);
          if (at != tube.end() && *at == w && !seen[at - tube.begin()])
          {
            seen[at - tube.begin()] = 1;
            stack.push_back(w);
          }
        }
      }
    }
    broken += !joined;
  }
  return { broken, static_cast<int>(phantom.report.strands.size()) };
}

/// Calls visit for the 27 voxels around and at v that lie in the image; stops at the first that returns
/// false.
template<typename Visit>
bool All27(const GridGeometry& grid, Id v, const Visit& visit)
{
  const auto p = PlaceOf(grid, v);
  for (int n = 0; n < 27; ++n)
  {
    const Id q[3] = { p[0] + n % 3 - 1, p[1] + n / 3 % 3 - 1, p[2] + n / 9 - 1 };
    const bool inside = q[0] >= 0 && q[1] >= 0 && q[2] >= 0 && q[0] < grid.size[0] && q[1] < grid.size[1] &&
                        q[2] < grid.size[2];
    if (inside && !visit(grid.Index(q[0], q[1], q[2])))
    {
      return false;
    }
  }
  return true;
}

/// Voxels of walls and leaflets at most two voxels thick: tissue next to no place where it is three voxels
/// thick.
inline std::vector<Id> ThinTissue(const LabelImage& truth)
{
  const auto body = [&](Id v)
  { return All27(truth.grid, v, [&](Id w) { return truth.labels[w] == Tissue; }); };
  std::vector<Id> voxels;
  for (Id v = 0; v < truth.grid.Count(); ++v)
  {
    if (truth.labels[v] == Tissue && All27(truth.grid, v, [&](Id w) { return !body(w); }))
    {
      voxels.push_back(v);
    }
  }
  return voxels;
}

} // namespace lamina::scores
