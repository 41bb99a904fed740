// SPDX-License-Identifier: BSD-3-Clause
#include "QuadraticHarmonic.h"

#include "../Mesh/Adjacency.h"
#include "../Mesh/CellFaces.h"
#include "CellTets.h"

#include <algorithm>

namespace lamina
{
namespace
{

constexpr Id Grain = 2048;
constexpr std::size_t NodesOfTet = 10; ///< four corners, six edges
constexpr std::size_t EdgesOfTet[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
/// The linear solution is near: what is left are short waves, and they die out fast.
constexpr double Tolerance = 1e-5;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

using TetNodes = std::array<Id, NodesOfTet>;
using TetValues = std::array<double, NodesOfTet>;

/// What the stiffness of one tet makes of its values. The gradient is linear in the tet, so its four values
/// at the corners say all.
TetValues MultiplyTet(const TetShape& shape, const TetValues& u)
{
  const auto& g = shape.gradients;
  std::array<Vec3, 4> gradient; // at the corners
  for (std::size_t m = 0; m < 4; ++m)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      gradient[m] += (i == m ? 3 : -1) * u[i] * g[i];
    }
  }
  for (std::size_t e = 0; e < 6; ++e)
  {
    const auto [i, j] = EdgesOfTet[e];
    gradient[i] += 4 * u[4 + e] * g[j];
    gradient[j] += 4 * u[4 + e] * g[i];
  }
  const Vec3 sum = gradient[0] + gradient[1] + gradient[2] + gradient[3];
  TetValues y{};
  for (std::size_t i = 0; i < 4; ++i)
  {
    y[i] = shape.volume / 20 * Dot(g[i], 4 * gradient[i] - sum);
  }
  for (std::size_t e = 0; e < 6; ++e)
  {
    const auto [i, j] = EdgesOfTet[e];
    y[4 + e] = shape.volume / 5 * (Dot(g[j], sum + gradient[i]) + Dot(g[i], sum + gradient[j]));
  }
  return y;
}

TetValues DiagonalOfTet(const TetShape& shape)
{
  const auto& g = shape.gradients;
  TetValues d{};
  for (std::size_t i = 0; i < 4; ++i)
  {
    d[i] = 0.6 * shape.volume * Norm2(g[i]);
  }
  for (std::size_t e = 0; e < 6; ++e)
  {
    const auto [i, j] = EdgesOfTet[e];
    d[4 + e] = 1.6 * shape.volume * (Norm2(g[i]) + Norm2(g[j]) + Dot(g[i], g[j]));
  }
  return d;
}

/// The elements, with the points and then the edges of their tets as nodes. No matrix is kept: each tet
/// multiplies its part, and each node adds up what its tets made, in one order.
class QuadraticElements
{
public:
  QuadraticElements(const VolumeMesh& mesh, const std::vector<Id>& cells)
    : Mesh(mesh)
  {
    for (const Id c : cells)
    {
      const CellTets parts = TetsOfCell(mesh, c);
      for (int t = 0; t < parts.count; ++t)
      {
        const auto& tet = parts.tets[static_cast<std::size_t>(t)];
        this->Nodes.push_back({ { tet[0], tet[1], tet[2], tet[3], 0, 0, 0, 0, 0, 0 } });
        this->Weights.push_back(parts.weight);
      }
    }
    this->NumberEdges();
    this->LinkNodes();
    this->Made.resize(this->Nodes.size());
  }

  std::size_t NodeCount() const { return this->Mesh.points.size() + this->Edges.size(); }
  const std::vector<Edge>& GetEdges() const { return this->Edges; }
  bool IsUsed(std::size_t node) const
  {
    return this->PartsOf.offsets[node + 1] > this->PartsOf.offsets[node];
  }
  Id NodeOf(Edge edge) const
  {
    const auto found = std::lower_bound(this->Edges.begin(), this->Edges.end(), edge, Before);
    return found != this->Edges.end() && !Before(edge, *found)
             ? static_cast<Id>(this->Mesh.points.size()) + (found - this->Edges.begin())
             : -1;
  }

  /// Calls make(shape, values at the tet's nodes) for every tet and adds up what comes out.
  template<typename Make>
  void Gather(const std::vector<double>& from, const Make& make, std::vector<double>& to, Monitor& monitor)
  {
    monitor.For(static_cast<Id>(this->Nodes.size()), Grain,
                [&](Id begin, Id end)
                {
                  for (Id t = begin; t < end; ++t)
                  {
                    const TetNodes& n = this->Nodes[Index(t)];
                    TetShape shape = ShapeOf(this->Mesh, { { n[0], n[1], n[2], n[3] } });
                    shape.volume *= this->Weights[Index(t)];
                    TetValues u;
                    for (std::size_t k = 0; k < NodesOfTet; ++k)
                    {
                      u[k] = from[Index(n[k])];
                    }
                    this->Made[Index(t)] = make(shape, u);
                  }
                });
    monitor.For(static_cast<Id>(this->NodeCount()), Grain,
                [&](Id begin, Id end)
                {
                  for (Id node = begin; node < end; ++node)
                  {
                    double sum = 0;
                    for (const Id part : Row(this->PartsOf, node))
                    {
                      const auto at = static_cast<std::size_t>(part);
                      sum += this->Made[at / NodesOfTet][at % NodesOfTet];
                    }
                    to[Index(node)] = sum;
                  }
                });
  }

private:
  static bool Before(const Edge& a, const Edge& b) { return a.a != b.a ? a.a < b.a : a.b < b.b; }
  static Edge EdgeOf(const TetNodes& n, std::size_t e)
  {
    const auto ends = std::minmax(n[EdgesOfTet[e][0]], n[EdgesOfTet[e][1]]);
    return { ends.first, ends.second };
  }

  void NumberEdges()
  {
    this->Edges.reserve(6 * this->Nodes.size());
    for (const TetNodes& n : this->Nodes)
    {
      for (std::size_t e = 0; e < 6; ++e)
      {
        this->Edges.push_back(EdgeOf(n, e));
      }
    }
    std::sort(this->Edges.begin(), this->Edges.end(), Before);
    const auto same = [](const Edge& a, const Edge& b) { return a.a == b.a && a.b == b.b; };
    this->Edges.erase(std::unique(this->Edges.begin(), this->Edges.end(), same), this->Edges.end());
    this->Edges.shrink_to_fit();
    for (TetNodes& n : this->Nodes)
    {
      for (std::size_t e = 0; e < 6; ++e)
      {
        n[4 + e] = this->NodeOf(EdgeOf(n, e));
      }
    }
  }

  void LinkNodes()
  {
    std::vector<Id>& offsets = this->PartsOf.offsets;
    offsets.assign(this->NodeCount() + 1, 0);
    for (const TetNodes& n : this->Nodes)
    {
      for (const Id node : n)
      {
        ++offsets[Index(node) + 1];
      }
    }
    for (std::size_t i = 1; i < offsets.size(); ++i)
    {
      offsets[i] += offsets[i - 1];
    }
    this->PartsOf.data.resize(NodesOfTet * this->Nodes.size());
    std::vector<Id> next(offsets.begin(), offsets.end() - 1);
    for (std::size_t t = 0; t < this->Nodes.size(); ++t)
    {
      for (std::size_t k = 0; k < NodesOfTet; ++k)
      {
        this->PartsOf.data[Index(next[Index(this->Nodes[t][k])]++)] = static_cast<Id>(NodesOfTet * t + k);
      }
    }
  }

  const VolumeMesh& Mesh;
  std::vector<TetNodes> Nodes;
  std::vector<double> Weights;
  std::vector<Edge> Edges; ///< ascending
  Lists PartsOf;           ///< of nodes: ten times a tet's number plus the node's place in it
  std::vector<TetValues> Made;
};

/// Calls visit(edge) for the edges of triangles, and for both diagonals of the quads that they are halves of.
template<typename Visit>
void ForWallEdges(const VolumeMesh& mesh, const std::vector<Id>& cells, std::vector<Triangle> walls,
                  const Visit& visit)
{
  for (Triangle& t : walls)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      visit(t[k], t[(k + 1) % 3]);
    }
    std::sort(t.begin(), t.end());
  }
  std::sort(walls.begin(), walls.end());
  for (const Id c : cells)
  {
    const CellType type = mesh.types[Index(c)];
    for (int f = 0; type != CellType::Tetrahedron && f < FaceCount(type); ++f)
    {
      const CellFace face = FaceOf(mesh, c, f);
      bool isWall = false;
      for (std::size_t left = 0; face.IsQuad() && left < 4; ++left)
      {
        Triangle half{ { face.corners[(left + 1) % 4], face.corners[(left + 2) % 4],
                         face.corners[(left + 3) % 4] } };
        std::sort(half.begin(), half.end());
        isWall = isWall || std::binary_search(walls.begin(), walls.end(), half);
      }
      if (isWall)
      {
        visit(face.corners[0], face.corners[2]);
        visit(face.corners[1], face.corners[3]);
      }
    }
  }
}

/// One a node: whether its value is given; that of a node of no cell counts as given.
std::vector<char> KnownNodes(const QuadraticElements& elements, const VolumeMesh& mesh,
                             const std::vector<Id>& cells, const std::vector<char>& known,
                             const std::vector<Triangle>& walls)
{
  std::vector<char> fixed(elements.NodeCount(), 0);
  std::copy(known.begin(), known.end(), fixed.begin());
  ForWallEdges(mesh, cells, walls,
               [&](Id a, Id b)
               {
                 const Id node = elements.NodeOf({ std::min(a, b), std::max(a, b) });
                 if (node >= 0)
                 {
                   fixed[Index(node)] = 1;
                 }
               });
  for (std::size_t node = 0; node < fixed.size(); ++node)
  {
    fixed[node] = elements.IsUsed(node) ? fixed[node] : 1;
  }
  return fixed;
}

} // namespace

Result<HarmonicReport> SolveQuadraticHarmonic(const VolumeMesh& mesh, const std::vector<Id>& cells,
                                              const std::vector<char>& known,
                                              const std::vector<Triangle>& walls, std::vector<double>& values,
                                              Monitor& monitor)
{
  QuadraticElements elements(mesh, cells);
  const std::vector<char> fixed = KnownNodes(elements, mesh, cells, known, walls);
  std::vector<double> all = values;
  for (const Edge& edge : elements.GetEdges())
  {
    all.push_back(0.5 * (values[Index(edge.a)] + values[Index(edge.b)]));
  }
  // The unknown is the change of the start: it is 0 where values are known.
  std::vector<double> right(all.size());
  elements.Gather(all, MultiplyTet, right, monitor);
  std::vector<double> diagonal(all.size());
  elements.Gather(
    all, [](const TetShape& shape, const TetValues&) { return DiagonalOfTet(shape); }, diagonal, monitor);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    right[i] = fixed[i] ? 0 : -right[i];
    diagonal[i] = fixed[i] ? 0 : diagonal[i];
  }
  const auto multiply = [&](const std::vector<double>& from, std::vector<double>& to)
  {
    elements.Gather(from, MultiplyTet, to, monitor);
    for (std::size_t i = 0; i < to.size(); ++i)
    {
      to[i] = fixed[i] ? 0 : to[i];
    }
  };
  std::vector<double> change(all.size(), 0);
  const ConjugateGradientsOptions options{ Tolerance, 20000, "Solving for the depth" };
  const HarmonicReport solved = ConjugateGradients({ multiply, diagonal, right }, options, change, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  if (auto error = CheckSolved(solved))
  {
    return *error;
  }
  for (std::size_t p = 0; p < values.size(); ++p)
  {
    values[p] += change[p];
  }
  return solved;
}

} // namespace lamina
