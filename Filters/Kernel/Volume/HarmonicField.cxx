// SPDX-License-Identifier: BSD-3-Clause
#include "HarmonicField.h"

#include "../Mesh/Adjacency.h"
#include "CellTets.h"

#include <algorithm>
#include <cmath>

namespace lamina
{
namespace
{

constexpr Id Grain = 4096; ///< also the blocks of sums, so that they do not depend on the threads
constexpr double Tolerance = 1e-8;
constexpr int MostIterations = 20000;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

/// Rows of unknowns: the diagonal, the other unknowns' entries, and what the known values contribute.
class Laplacian
{
public:
  Laplacian(const VolumeMesh& mesh, const std::vector<Id>& cells, const std::vector<char>& known,
            const std::vector<double>& values, Monitor& monitor)
    : Mesh(mesh)
    , Unknown(mesh.points.size(), -1)
  {
    this->Number(cells, known);
    this->Assemble(values, monitor);
  }
  const std::vector<Id>& Points() const { return this->PointOf; }
  const std::vector<double>& Diagonal() const { return this->Diagonals; }
  const std::vector<double>& RightSide() const { return this->Right; }
  void Multiply(const std::vector<double>& x, std::vector<double>& y, Monitor& monitor) const
  {
    monitor.For(static_cast<Id>(x.size()), Grain,
                [&](Id begin, Id end)
                {
                  for (Id i = begin; i < end; ++i)
                  {
                    double sum = this->Diagonals[Index(i)] * x[Index(i)];
                    for (const auto& [column, entry] : this->Rows[Index(i)])
                    {
                      sum += entry * x[Index(column)];
                    }
                    y[Index(i)] = sum;
                  }
                });
  }

private:
  void Number(const std::vector<Id>& cells, const std::vector<char>& known)
  {
    std::vector<Id> count(this->Mesh.points.size() + 1, 0);
    const auto forNodes = [&](const auto& visit)
    {
      for (Id c : cells)
      {
        const int n = NodeCount(this->Mesh.types[Index(c)]);
        for (int k = 0; k < n; ++k)
        {
          visit(c, this->Mesh.Cell(c)[k]);
        }
      }
    };
    forNodes([&](Id, Id p) { ++count[Index(p) + 1]; });
    for (std::size_t p = 0; p < this->Unknown.size(); ++p)
    {
      if (count[p + 1] > 0 && known[p] == 0)
      {
        this->Unknown[p] = static_cast<Id>(this->PointOf.size());
        this->PointOf.push_back(static_cast<Id>(p));
      }
      count[p + 1] += count[p];
    }
    this->CellsOf.offsets = count;
    this->CellsOf.data.resize(Index(count.back()));
    forNodes([&](Id c, Id p) { this->CellsOf.data[Index(count[Index(p)]++)] = c; });
  }

  /// Row by row, as every row's sum must have one order.
  void Assemble(const std::vector<double>& values, Monitor& monitor)
  {
    const std::size_t count = this->PointOf.size();
    this->Rows.resize(count);
    this->Diagonals.assign(count, 0);
    this->Right.assign(count, 0);
    monitor.For(static_cast<Id>(count), 512,
                [&](Id begin, Id end)
                {
                  for (Id i = begin; i < end; ++i)
                  {
                    this->AssembleRow(i, values);
                  }
                });
  }

  void AssembleRow(Id row, const std::vector<double>& values)
  {
    const Id point = this->PointOf[Index(row)];
    auto& entries = this->Rows[Index(row)];
    for (Id c : lamina::Row(this->CellsOf, point))
    {
      const CellTets parts = TetsOfCell(this->Mesh, c);
      for (int t = 0; t < parts.count; ++t)
      {
        const auto& tet = parts.tets[static_cast<std::size_t>(t)];
        const std::size_t own = Index(std::find(tet.begin(), tet.end(), point) - tet.begin());
        if (own == tet.size())
        {
          continue;
        }
        const TetShape shape = ShapeOf(this->Mesh, tet);
        for (std::size_t k = 0; k < 4; ++k)
        {
          const double entry = parts.weight * shape.volume * Dot(shape.gradients[own], shape.gradients[k]);
          const Id column = this->Unknown[Index(tet[k])];
          if (k == own)
          {
            this->Diagonals[Index(row)] += entry;
          }
          else if (column < 0)
          {
            this->Right[Index(row)] -= entry * values[Index(tet[k])];
          }
          else
          {
            entries.push_back({ column, entry });
          }
        }
      }
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::size_t last = 0;
    for (std::size_t k = 1; k < entries.size(); ++k)
    {
      if (entries[k].first == entries[last].first)
      {
        entries[last].second += entries[k].second;
      }
      else
      {
        entries[++last] = entries[k];
      }
    }
    entries.resize(entries.empty() ? 0 : last + 1);
    entries.shrink_to_fit();
  }

  const VolumeMesh& Mesh;
  std::vector<Id> Unknown; ///< one a point: its row, else -1
  std::vector<Id> PointOf;
  Lists CellsOf;
  std::vector<std::vector<std::pair<Id, double>>> Rows;
  std::vector<double> Diagonals;
  std::vector<double> Right;
};

double DotProduct(const std::vector<double>& a, const std::vector<double>& b, Monitor& monitor)
{
  const Id count = static_cast<Id>(a.size());
  std::vector<double> parts(Index((count + Grain - 1) / Grain), 0);
  monitor.For(static_cast<Id>(parts.size()), 1,
              [&](Id begin, Id end)
              {
                for (Id block = begin; block < end; ++block)
                {
                  double sum = 0;
                  for (Id i = block * Grain; i < std::min(count, (block + 1) * Grain); ++i)
                  {
                    sum += a[Index(i)] * b[Index(i)];
                  }
                  parts[Index(block)] = sum;
                }
              });
  double sum = 0;
  for (double part : parts)
  {
    sum += part;
  }
  return sum;
}

/// Calls op(i) for all i.
template<typename Op>
void ForAll(std::size_t count, Monitor& monitor, Op&& op)
{
  monitor.For(static_cast<Id>(count), Grain,
              [&](Id begin, Id end)
              {
                for (Id i = begin; i < end; ++i)
                {
                  op(Index(i));
                }
              });
}

} // namespace

Result<HarmonicReport> SolveHarmonic(const VolumeMesh& mesh, const std::vector<Id>& cells,
                                     const std::vector<char>& known, std::vector<double>& values,
                                     Monitor& monitor)
{
  const Laplacian matrix(mesh, cells, known, values, monitor);
  const std::size_t count = matrix.Points().size();
  std::vector<double> x(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    x[i] = values[Index(matrix.Points()[i])];
  }
  HarmonicReport report;
  std::vector<double> product(count);
  matrix.Multiply(x, product, monitor);
  std::vector<double> rest(count);
  std::vector<double> scaled(count);
  const auto scale = [&](std::size_t i)
  { scaled[i] = matrix.Diagonal()[i] > 0 ? rest[i] / matrix.Diagonal()[i] : 0; };
  ForAll(count, monitor,
         [&](std::size_t i)
         {
           rest[i] = matrix.RightSide()[i] - product[i];
           scale(i);
         });
  std::vector<double> way = scaled;
  double energy = DotProduct(rest, scaled, monitor);
  const double first = energy;
  while (energy > Tolerance * Tolerance * first && report.iterations < MostIterations && !monitor.Cancelled())
  {
    monitor.Progress(std::min(1.0, std::log(energy / first) / (2 * std::log(Tolerance))),
                     "Solving for the depth");
    matrix.Multiply(way, product, monitor);
    const double step = energy / DotProduct(way, product, monitor);
    ForAll(count, monitor,
           [&](std::size_t i)
           {
             x[i] += step * way[i];
             rest[i] -= step * product[i];
             scale(i);
           });
    const double next = DotProduct(rest, scaled, monitor);
    const double turn = next / energy;
    energy = next;
    ForAll(count, monitor, [&](std::size_t i) { way[i] = scaled[i] + turn * way[i]; });
    ++report.iterations;
  }
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  report.residual = first > 0 ? std::sqrt(energy / first) : 0;
  if (!(report.residual <= 1e-3))
  {
    return Unreachable("the equation of the depth could not be solved in " +
                       std::to_string(report.iterations) + " steps: look for flat cells with Mesh Audit");
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    values[Index(matrix.Points()[i])] = x[i];
  }
  return report;
}

} // namespace lamina
