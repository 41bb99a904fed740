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

constexpr Id Grain = 4096;

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

} // namespace

std::optional<Error> CheckSolved(const HarmonicReport& report)
{
  if (report.residual <= 1e-3)
  {
    return std::nullopt;
  }
  return Unreachable("the equation of the depth could not be solved in " + std::to_string(report.iterations) +
                     " steps: look for flat cells with Mesh Audit");
}

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
  const auto multiply = [&](const std::vector<double>& from, std::vector<double>& to)
  { matrix.Multiply(from, to, monitor); };
  ConjugateGradientsOptions options;
  options.stage = "Solving for the depth";
  const ConjugateGradientsReport report =
    ConjugateGradients({ multiply, matrix.Diagonal(), matrix.RightSide() }, options, x, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  if (auto error = CheckSolved(report))
  {
    return *error;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    values[Index(matrix.Points()[i])] = x[i];
  }
  return report;
}

} // namespace lamina
