// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeCorrection.h"

#include "JunctionGraph.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <limits>
#include <numeric>

namespace lamina
{

namespace
{

class UnionFind
{
public:
  explicit UnionFind(std::size_t count)
    : Root(count)
  {
    std::iota(this->Root.begin(), this->Root.end(), std::size_t{ 0 });
  }
  std::size_t Find(std::size_t i)
  {
    while (this->Root[i] != i)
    {
      i = this->Root[i] = this->Root[this->Root[i]];
    }
    return i;
  }
  void Join(std::size_t i, std::size_t j)
  {
    i = this->Find(i);
    j = this->Find(j);
    this->Root[std::max(i, j)] = std::min(i, j);
  }

private:
  std::vector<std::size_t> Root;
};

int MaterialAt(const TriangleComplex& surface, std::size_t triangle, int side)
{
  const MaterialPair& pair = surface.materials[triangle];
  return side == 0 ? pair.first : pair.second;
}

/// The centre of the points' bounding box: volumes are summed about it, so that a far-off origin costs no
/// digits.
Vec3 LocalOrigin(const std::vector<Vec3>& points)
{
  if (points.empty())
  {
    return {};
  }
  Vec3 low = points[0];
  Vec3 high = points[0];
  for (const Vec3& p : points)
  {
    for (int c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  }
  return 0.5 * (low + high);
}

/// In long doubles: far from the origin the volumes of single triangles are large against that of a small
/// piece.
long double SixVolumes(const TriangleComplex& surface, const Triangle& t, const Vec3& origin)
{
  std::array<std::array<long double, 3>, 3> x;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3& p = surface.points[static_cast<std::size_t>(t[k])];
    for (int c = 0; c < 3; ++c)
    {
      x[k][static_cast<std::size_t>(c)] = static_cast<long double>(p[c]) - origin[c];
    }
  }
  return x[0][0] * (x[1][1] * x[2][2] - x[1][2] * x[2][1]) +
         x[0][1] * (x[1][2] * x[2][0] - x[1][0] * x[2][2]) +
         x[0][2] * (x[1][0] * x[2][1] - x[1][1] * x[2][0]);
}

} // namespace

SheetGraph MakeSheetGraph(const TriangleComplex& surface, bool background)
{
  const std::size_t count = surface.triangles.size();
  const EdgeTable table = MakeEdgeTable(surface.triangles);
  UnionFind sheets(count);
  UnionFind shells(2 * count); // node 2 * triangle + side
  for (std::size_t e = 0; e < table.edges.size(); ++e)
  {
    const ListRow row = Row(table.triangles, static_cast<Id>(e));
    const bool feature = IsFeatureEdge(surface, row.first, row.last);
    for (const Id* s = row.first; s != row.last; ++s)
    {
      for (const Id* t = s + 1; t != row.last; ++t)
      {
        const auto i = static_cast<std::size_t>(*s);
        const auto j = static_cast<std::size_t>(*t);
        if (!feature)
        {
          sheets.Join(i, j);
        }
        for (std::size_t side = 0; side < 4; ++side)
        {
          if (MaterialAt(surface, i, static_cast<int>(side / 2)) ==
              MaterialAt(surface, j, static_cast<int>(side % 2)))
          {
            shells.Join(2 * i + side / 2, 2 * j + side % 2);
          }
        }
      }
    }
  }
  SheetGraph graph;
  graph.sheetOfTriangle.resize(count);
  std::vector<int> shellOfRoot(2 * count, -1);
  for (std::size_t t = 0; t < count; ++t)
  {
    const std::size_t root = sheets.Find(t);
    if (root == t)
    {
      graph.sheetOfTriangle[t] = static_cast<int>(graph.shellsOfSheet.size());
      std::array<int, 2> both{ { -1, -1 } };
      for (std::size_t side = 0; side < 2; ++side)
      {
        const int material = MaterialAt(surface, t, static_cast<int>(side));
        if (material == 0 && !background)
        {
          continue;
        }
        int& shell = shellOfRoot[shells.Find(2 * t + side)];
        if (shell < 0)
        {
          shell = graph.ShellCount();
          graph.materialOfShell.push_back(material);
        }
        both[side] = shell;
      }
      graph.shellsOfSheet.push_back(both);
    }
    else
    {
      graph.sheetOfTriangle[t] = graph.sheetOfTriangle[root];
    }
  }
  return graph;
}

std::vector<double> ShellVolumes(const TriangleComplex& surface, const SheetGraph& graph)
{
  const Vec3 origin = LocalOrigin(surface.points);
  std::vector<long double> sums(static_cast<std::size_t>(graph.ShellCount()), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const long double six = SixVolumes(surface, surface.triangles[t], origin);
    const auto& both = graph.shellsOfSheet[static_cast<std::size_t>(graph.sheetOfTriangle[t])];
    if (both[0] >= 0)
    {
      sums[static_cast<std::size_t>(both[0])] += six;
    }
    if (both[1] >= 0)
    {
      sums[static_cast<std::size_t>(both[1])] -= six;
    }
  }
  std::vector<double> volumes;
  for (long double sum : sums)
  {
    volumes.push_back(static_cast<double>(sum / 6));
  }
  return volumes;
}

std::vector<double> MaterialVolumes(const TriangleComplex& surface, const std::vector<int>& materials)
{
  const Vec3 origin = LocalOrigin(surface.points);
  std::vector<long double> sums(materials.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const long double six = SixVolumes(surface, surface.triangles[t], origin);
    for (std::size_t m = 0; m < materials.size(); ++m)
    {
      sums[m] += static_cast<long double>(SideOf(surface.materials[t], materials[m])) * six;
    }
  }
  std::vector<double> volumes;
  for (long double sum : sums)
  {
    volumes.push_back(static_cast<double>(sum / 6));
  }
  return volumes;
}

std::optional<Error> CheckSides(const TriangleComplex& surface, const std::vector<int>& materials)
{
  const std::vector<double> volumes = MaterialVolumes(surface, materials);
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    if (!(volumes[m] > 0))
    {
      const auto at = std::find_if(surface.materials.begin(), surface.materials.end(),
                                   [&](const MaterialPair& pair) { return SideOf(pair, materials[m]) != 0; });
      const Triangle& t = surface.triangles[static_cast<std::size_t>(at - surface.materials.begin())];
      return InvalidInput("material " + std::to_string(materials[m]) +
                            " is inside out or flat (its boundary encloses a volume of " +
                            std::to_string(volumes[m]) +
                            "): turn its triangles over (Reverse Sense), or correct BoundaryLabels",
                          { surface.points[static_cast<std::size_t>(t[0])] });
    }
  }
  return std::nullopt;
}

namespace
{

/// How the inner points of the sheets move, and what that does to volumes.
struct Motion
{
  std::vector<int> sheetOfPoint;   ///< -1: stays
  std::vector<Vec3> normals;       ///< unit, along the triangles' normals
  std::vector<double> areaOfSheet; ///< dV / dheight of the pair's first material
};

Motion MakeMotion(const TriangleComplex& surface, const SheetGraph& graph, const std::vector<char>& stays)
{
  Motion motion;
  motion.sheetOfPoint.assign(surface.points.size(), -2);
  motion.normals.assign(surface.points.size(), Vec3{});
  motion.areaOfSheet.assign(graph.shellsOfSheet.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Vec3 area = AreaVector2(surface.points, surface.triangles[t]);
    for (Id p : surface.triangles[t])
    {
      const auto v = static_cast<std::size_t>(p);
      int& sheet = motion.sheetOfPoint[v];
      sheet = sheet == -2 || sheet == graph.sheetOfTriangle[t] ? graph.sheetOfTriangle[t] : -1;
      motion.normals[v] += area;
    }
  }
  for (std::size_t v = 0; v < surface.points.size(); ++v)
  {
    const bool inner =
      (surface.junctionKind.empty() || surface.junctionKind[v] == JunctionSheet) && !stays[v];
    const double six = Norm(motion.normals[v]); // closed fan: the sum of area vectors is the gradient of 6 V
    if (motion.sheetOfPoint[v] < 0 || !inner || six == 0)
    {
      motion.sheetOfPoint[v] = -1;
      continue;
    }
    motion.normals[v] *= 1 / six;
    motion.areaOfSheet[static_cast<std::size_t>(motion.sheetOfPoint[v])] += six / 6;
  }
  return motion;
}

/// Heights of the sheets that change the shells' volumes by `wanted` to first order, least in the mean over
/// the area.
std::vector<double> SolveHeights(const SheetGraph& graph, const Motion& motion,
                                 const std::vector<double>& wanted)
{
  using Sparse = Eigen::SparseMatrix<double>;
  const auto shells = static_cast<Eigen::Index>(wanted.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t s = 0; s < graph.shellsOfSheet.size(); ++s)
  {
    const double area = motion.areaOfSheet[s];
    const auto& both = graph.shellsOfSheet[s];
    for (int i = 0; i < 4; ++i)
    {
      const int a = both[static_cast<std::size_t>(i / 2)];
      const int b = both[static_cast<std::size_t>(i % 2)];
      if (a >= 0 && b >= 0)
      {
        entries.emplace_back(a, b, (i / 2 == i % 2 ? 1 : -1) * area);
      }
    }
  }
  Sparse matrix(shells, shells);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd right(shells);
  for (Eigen::Index i = 0; i < shells; ++i)
  {
    right[i] = wanted[static_cast<std::size_t>(i)];
  }
  // Where a sheet has the same two shells as others, or none of its points may move, conditions repeat or are
  // empty: a tiny ridge makes the system definite, and Newton's rounds take out what little it changes.
  double trace = 0;
  for (Eigen::Index i = 0; i < shells; ++i)
  {
    trace += matrix.coeff(i, i);
  }
  for (Eigen::Index i = 0; i < shells; ++i)
  {
    matrix.coeffRef(i, i) += 1e-11 * trace / static_cast<double>(shells) + 1e-300;
  }
  Eigen::SimplicialLDLT<Sparse> solver(matrix);
  const Eigen::VectorXd lambda = solver.solve(right);
  std::vector<double> heights(graph.shellsOfSheet.size(), 0);
  for (std::size_t s = 0; s < heights.size(); ++s)
  {
    const auto& both = graph.shellsOfSheet[s];
    const double first = both[0] >= 0 ? lambda[both[0]] : 0;
    const double second = both[1] >= 0 ? lambda[both[1]] : 0;
    heights[s] = std::isfinite(first - second) ? first - second : 0;
  }
  return heights;
}

} // namespace

namespace
{

/// Move the points by the heights of their sheets, none farther from its start than its reach: there it stays
/// from then on. Returns whether any came that far.
bool MovePoints(std::vector<Vec3>& points, const Motion& motion, const std::vector<double>& heights,
                const std::vector<Vec3>& start, const std::vector<double>& reach, std::vector<char>& stays)
{
  bool any = false;
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    if (motion.sheetOfPoint[v] < 0)
    {
      continue;
    }
    points[v] += heights[static_cast<std::size_t>(motion.sheetOfPoint[v])] * motion.normals[v];
    const Vec3 moved = points[v] - start[v];
    if (!reach.empty() && Norm(moved) > reach[v])
    {
      points[v] = start[v] + (reach[v] / Norm(moved)) * moved;
      stays[v] = 1;
      any = true;
    }
  }
  return any;
}

} // namespace

double RestoreVolumes(TriangleComplex& surface, const SheetGraph& graph, const std::vector<double>& targets,
                      const std::vector<double>& reach)
{
  constexpr int mostRounds = 40;
  constexpr int enoughRounds = 8; // where no point comes to its limit
  const std::vector<Vec3> start = surface.points;
  std::vector<char> stays(start.size(), 0);
  for (std::size_t v = 0; v < reach.size(); ++v)
  {
    stays[v] = reach[v] > 0 ? 0 : 1;
  }
  std::vector<Vec3> best = start;
  double least = std::numeric_limits<double>::infinity();
  double leastSum = least;
  bool stopped = false;
  for (int round = 0, free = 0; round < mostRounds && free < enoughRounds; ++round, free += stopped ? 0 : 1)
  {
    const std::vector<double> volumes = ShellVolumes(surface, graph);
    std::vector<double> wanted(targets.size());
    double worst = 0;
    double sum = 0; // of the errors: the worst may be out of reach
    for (std::size_t s = 0; s < targets.size(); ++s)
    {
      wanted[s] = targets[s] - volumes[s];
      const double error = std::abs(wanted[s]) / std::max(std::abs(targets[s]), 1e-300);
      worst = std::max(worst, error);
      sum += error;
    }
    if (sum < leastSum)
    {
      leastSum = sum;
      least = worst;
      best = surface.points;
    }
    if (worst < 2e-15 || (sum > 2 * leastSum && !stopped))
    {
      break;
    }
    const Motion motion = MakeMotion(surface, graph, stays);
    const std::vector<double> heights = SolveHeights(graph, motion, wanted);
    stopped = MovePoints(surface.points, motion, heights, start, reach, stays);
  }
  surface.points = std::move(best);
  return least;
}

} // namespace lamina
