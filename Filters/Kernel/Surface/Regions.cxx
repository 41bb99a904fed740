// SPDX-License-Identifier: BSD-3-Clause
#include "Regions.h"

#include "../Search/TriangleTree.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace lamina
{

namespace
{

std::size_t At(Id i)
{
  return static_cast<std::size_t>(i);
}

/// Of each shell the point with the least x, the lowest id where several have it.
std::vector<Id> ForemostPoints(const TriangleComplex& surface, const SheetGraph& graph)
{
  std::vector<Id> foremost(At(graph.ShellCount()), -1);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    for (const int shell : graph.shellsOfSheet[At(graph.sheetOfTriangle[t])])
    {
      for (const Id p : surface.triangles[t])
      {
        Id& best = foremost[At(shell)];
        const double x = surface.points[At(p)].x;
        const double least = best < 0 ? std::numeric_limits<double>::infinity() : surface.points[At(best)].x;
        best = x < least || (x == least && p < best) ? p : best;
      }
    }
  }
  return foremost;
}

/// The shell of the same material that a ray from a cavity's foremost point meets first, -1 for none: what is
/// in between belongs to the material.
int ShellInFront(const TriangleComplex& surface, const SheetGraph& graph, const TriangleTree& tree, int shell,
                 Id from)
{
  const int material = graph.materialOfShell[At(shell)];
  const auto hit =
    tree.FirstHit(surface.points[At(from)], { -1, 0, 0 }, 0, std::numeric_limits<double>::infinity(),
                  [&](Id t)
                  {
                    const Triangle& c = surface.triangles[At(t)];
                    return std::find(c.begin(), c.end(), from) == c.end() &&
                           SideOf(surface.materials[At(t)], material) != 0;
                  });
  if (hit.triangle < 0)
  {
    return -1;
  }
  const auto& both = graph.shellsOfSheet[At(graph.sheetOfTriangle[At(hit.triangle)])];
  return both[SideOf(surface.materials[At(hit.triangle)], material) > 0 ? 0 : 1];
}

} // namespace

SheetGraph MakeRegions(const TriangleComplex& surface)
{
  SheetGraph graph = MakeSheetGraph(surface, true);
  const std::vector<double> volumes = ShellVolumes(surface, graph);
  const std::vector<Id> foremost = ForemostPoints(surface, graph);
  const TriangleTree tree(surface.points, surface.triangles);
  // Cavities join what lies in front of them; `count` stands for the surroundings.
  const std::size_t count = volumes.size();
  std::vector<std::size_t> root(count + 1);
  std::iota(root.begin(), root.end(), std::size_t{ 0 });
  const auto find = [&root](std::size_t i)
  {
    while (root[i] != i)
    {
      i = root[i] = root[root[i]];
    }
    return i;
  };
  for (std::size_t s = 0; s < count; ++s)
  {
    if (volumes[s] < 0)
    {
      const int front = ShellInFront(surface, graph, tree, static_cast<int>(s), foremost[s]);
      const std::size_t other = find(front >= 0 ? At(front) : (graph.materialOfShell[s] == 0 ? count : s));
      const std::size_t own = find(s);
      root[std::min(own, other)] = std::max(own, other); // the surroundings are the last
    }
  }
  std::vector<int> regionOf(count + 1, -1);
  std::vector<int> materials;
  for (std::size_t s = 0; s < count; ++s)
  {
    int& region = regionOf[find(s)];
    if (region < 0 && find(s) != count)
    {
      region = static_cast<int>(materials.size());
      materials.push_back(graph.materialOfShell[s]);
    }
  }
  for (auto& both : graph.shellsOfSheet)
  {
    for (int& shell : both)
    {
      shell = regionOf[find(At(shell))];
    }
  }
  graph.materialOfShell = std::move(materials);
  return graph;
}

std::vector<double> MissingVolumes(const TriangleComplex& surface, const SheetGraph& regions)
{
  std::vector<double> volumes(At(regions.ShellCount()), 0);
  for (std::size_t t = 0; t < surface.missing.size(); ++t)
  {
    const double area = 0.5 * Norm(AreaVector2(surface.points, surface.triangles[t]));
    const auto& both = regions.shellsOfSheet[At(regions.sheetOfTriangle[t])];
    for (std::size_t side = 0; side < 2; ++side)
    {
      if (both[side] >= 0)
      {
        volumes[At(both[side])] += surface.missing[t][side] * area * std::sqrt(area);
      }
    }
  }
  return volumes;
}

namespace
{

/// What a move of one point does to the volumes around it.
struct PointGradients
{
  struct Entry
  {
    int region;
    Vec3 gradient; ///< of the region's volume, within the point's freedom
  };
  std::array<Entry, 16> list;
  std::size_t count = 0;
  double area = 0; ///< a third of the triangles' around

  void Add(int region, const Vec3& gradient)
  {
    for (std::size_t i = 0; i < this->count; ++i)
    {
      if (this->list[i].region == region)
      {
        this->list[i].gradient += gradient;
        return;
      }
    }
    if (this->count < this->list.size()) // more pieces around a point leave it no freedom anyhow
    {
      this->list[this->count++] = { region, gradient };
    }
  }
};

PointGradients GradientsOf(const SmoothingState& state, const SheetGraph& regions, Id p)
{
  PointGradients g;
  const TriangleComplex& surface = state.surface;
  for (const Id t : Row(state.star, p))
  {
    const Vec3 six = AreaVector2(surface.points, surface.triangles[At(t)]);
    g.area += Norm(six) / 6;
    const auto& both = regions.shellsOfSheet[At(regions.sheetOfTriangle[At(t)])];
    g.Add(both[0], (1.0 / 6) * six);
    g.Add(both[1], (-1.0 / 6) * six);
  }
  for (std::size_t i = 0; i < g.count; ++i)
  {
    g.list[i].gradient = state.freedom[At(p)].Project(g.list[i].gradient);
  }
  return g;
}

/// The multipliers of the regions, from the sparse matrix of how far points serve two of them at once.
Eigen::VectorXd SolveMultipliers(const std::vector<Eigen::Triplet<double>>& entries,
                                 const std::vector<double>& wanted)
{
  using Sparse = Eigen::SparseMatrix<double>;
  const auto count = static_cast<Eigen::Index>(wanted.size());
  Sparse matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  // Regions none of whose points may move have empty rows: a tiny ridge makes the system definite.
  double trace = 0;
  for (Eigen::Index i = 0; i < count; ++i)
  {
    trace += matrix.coeff(i, i);
  }
  for (Eigen::Index i = 0; i < count; ++i)
  {
    matrix.coeffRef(i, i) += 1e-12 * matrix.coeff(i, i) + 1e-14 * trace / static_cast<double>(count) + 1e-300;
  }
  const Eigen::SimplicialLDLT<Sparse> solver(matrix);
  return solver.solve(Eigen::Map<const Eigen::VectorXd>(wanted.data(), count));
}

} // namespace

std::vector<Vec3> VolumeMoves(const SmoothingState& state, const SheetGraph& regions,
                              const std::vector<double>& wanted, const std::vector<char>& held,
                              Monitor& monitor)
{
  constexpr Id Grain = 16384;
  const Id count = static_cast<Id>(state.surface.points.size());
  const auto isFixed = [&](Id p)
  { return (!held.empty() && held[At(p)]) || state.freedom[At(p)].dimensions == 0; };
  // Per block of points what they add to the matrix, summed for each pair of regions: blocks, not threads,
  // decide the order of all sums.
  const Id blocks = (count + Grain - 1) / Grain;
  std::vector<std::vector<Eigen::Triplet<double>>> parts(At(blocks));
  monitor.For(blocks, 1,
              [&](Id begin, Id end)
              {
                for (Id p = begin * Grain; p < std::min(count, end * Grain); ++p)
                {
                  const PointGradients g = isFixed(p) ? PointGradients() : GradientsOf(state, regions, p);
                  auto& part = parts[At(p / Grain)];
                  for (std::size_t i = 0; i < g.count * g.count; ++i)
                  {
                    const auto& a = g.list[i / g.count];
                    const auto& b = g.list[i % g.count];
                    if (a.region < 0 || b.region < 0 || !(g.area > 0))
                    {
                      continue;
                    }
                    const double value = Dot(a.gradient, b.gradient) / g.area;
                    // Neighbours in memory mostly part the same two regions: their sum is one entry.
                    const std::size_t back = g.count * g.count;
                    auto same = part.end();
                    for (auto e = part.size() > back ? part.end() - static_cast<std::ptrdiff_t>(back)
                                                     : part.begin();
                         e != part.end(); ++e)
                    {
                      same = e->row() == a.region && e->col() == b.region ? e : same;
                    }
                    if (same != part.end())
                    {
                      *same = { a.region, b.region, same->value() + value };
                    }
                    else
                    {
                      part.emplace_back(a.region, b.region, value);
                    }
                  }
                }
              });
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& part : parts)
  {
    entries.insert(entries.end(), part.begin(), part.end());
  }
  const Eigen::VectorXd multipliers = SolveMultipliers(entries, wanted);
  std::vector<Vec3> moves(At(count));
  monitor.For(count, Grain,
              [&](Id begin, Id end)
              {
                for (Id p = begin; p < end; ++p)
                {
                  const PointGradients g = isFixed(p) ? PointGradients() : GradientsOf(state, regions, p);
                  Vec3 move;
                  for (std::size_t i = 0; i < g.count && g.area > 0; ++i)
                  {
                    const auto& entry = g.list[i];
                    move += (entry.region < 0 ? 0 : multipliers[entry.region] / g.area) * entry.gradient;
                  }
                  moves[At(p)] = IsFinite(move) ? move : Vec3{};
                }
              });
  return moves;
}

} // namespace lamina
