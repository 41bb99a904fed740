// SPDX-License-Identifier: BSD-3-Clause
#include "ConjugateGradients.h"

#include <algorithm>
#include <cmath>

namespace lamina
{
namespace
{

constexpr Id Grain = 4096; ///< also the blocks of sums

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

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

ConjugateGradientsReport ConjugateGradients(const LinearSystem& system,
                                            const ConjugateGradientsOptions& options, std::vector<double>& x,
                                            Monitor& monitor)
{
  const std::size_t count = x.size();
  std::vector<double> product(count);
  system.multiply(x, product);
  std::vector<double> rest(count);
  std::vector<double> scaled(count);
  const auto scale = [&](std::size_t i)
  { scaled[i] = system.diagonal[i] > 0 ? rest[i] / system.diagonal[i] : 0; };
  ForAll(count, monitor,
         [&](std::size_t i)
         {
           rest[i] = system.right[i] - product[i];
           scale(i);
         });
  std::vector<double> way = scaled;
  ConjugateGradientsReport report;
  double energy = DotProduct(rest, scaled, monitor);
  const double first = energy;
  const double tolerance = options.tolerance;
  while (energy > tolerance * tolerance * first && report.iterations < options.mostIterations &&
         !monitor.Cancelled())
  {
    monitor.Progress(std::min(1.0, std::log(energy / first) / (2 * std::log(tolerance))), options.stage);
    system.multiply(way, product);
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
  report.residual = first > 0 ? std::sqrt(energy / first) : 0;
  return report;
}

} // namespace lamina
