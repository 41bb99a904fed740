// SPDX-License-Identifier: BSD-3-Clause
#include "MaskCarrying.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamina
{

namespace
{

/// A drawn slice that is foretold from its neighbours, and by which displacements.
struct Foretelling
{
  const DrawnSlice* target = nullptr;
  const DrawnSlice* low = nullptr;
  const DrawnSlice* high = nullptr;
  const SliceField* toLow = nullptr;
  const SliceField* toHigh = nullptr;
};

/// Every drawn slice between two others; if there are but two, each from the other.
std::vector<Foretelling> PlanForetellings(const CarryWork& work, const std::vector<GapEnds>& ends)
{
  const std::size_t n = work.drawn.size();
  std::vector<const GapEnds*> above(n,
                                    nullptr); // each drawn slice's gap above, if it is filled from both sides
  for (std::size_t g = 0; g < work.gaps.size(); ++g)
  {
    const MaskGap& gap = work.gaps[g];
    if (gap.low >= 0 && gap.high >= 0 && !work.Drawn(gap.low)->assumed && !work.Drawn(gap.high)->assumed)
    {
      above[static_cast<std::size_t>(gap.low)] = &ends[g];
    }
  }
  std::vector<Foretelling> plan;
  for (std::size_t d = 1; d + 1 < n; ++d)
  {
    if (above[d - 1] && above[d] && !work.drawn[d].empty)
    {
      plan.push_back({ &work.drawn[d], &work.drawn[d - 1], &work.drawn[d + 1], &above[d - 1]->highToLow,
                       &above[d]->lowToHigh });
    }
  }
  for (std::size_t d = 0; plan.empty() && d + 1 < n; ++d)
  {
    if (above[d] && !work.drawn[d].empty && !work.drawn[d + 1].empty)
    {
      plan.push_back({ &work.drawn[d + 1], &work.drawn[d], nullptr, &above[d]->highToLow, nullptr });
      plan.push_back({ &work.drawn[d], nullptr, &work.drawn[d + 1], nullptr, &above[d]->lowToHigh });
      break;
    }
  }
  return plan;
}

struct Overlap
{
  double common = 0;
  double both = 0;

  double Dice() const { return this->both > 0 ? 2 * this->common / this->both : 1; }
};

Overlap Compare(const std::vector<int>& a, const std::vector<int>& b)
{
  Overlap overlap;
  for (std::size_t p = 0; p < a.size(); ++p)
  {
    overlap.common += a[p] != 0 && a[p] == b[p] ? 1 : 0;
    overlap.both += (a[p] != 0 ? 1 : 0) + (b[p] != 0 ? 1 : 0);
  }
  return overlap;
}

} // namespace

Foretold ForetellDrawn(const CarryWork& work, const std::vector<GapEnds>& ends, Monitor& monitor)
{
  Foretold result;
  result.dice.fill(std::numeric_limits<double>::quiet_NaN());
  const std::vector<Foretelling> plan = PlanForetellings(work, ends);
  const Id tries = static_cast<Id>(work.methods.size());
  std::vector<Overlap> overlaps(plan.size() * work.methods.size());
  monitor.For(static_cast<Id>(overlaps.size()), 1,
              [&](Id from, Id to)
              {
                for (Id t = from; t < to; ++t)
                {
                  const Foretelling& f = plan[static_cast<std::size_t>(t / tries)];
                  const CarriedSlice carried =
                    CarryToSlice(work.grid, work.Grey(f.target->slice), work.stack.noise,
                                 SourcesOf(work, f.target->slice, f.low, f.toLow, f.high, f.toHigh), work.ids,
                                 work.methods[static_cast<std::size_t>(t % tries)], *work.warper);
                  overlaps[static_cast<std::size_t>(t)] = Compare(carried.labels, f.target->labels);
                }
              });
  for (std::size_t m = 0; m < work.methods.size() && !plan.empty(); ++m)
  {
    Overlap sum;
    for (std::size_t f = 0; f < plan.size(); ++f)
    {
      const Overlap& one = overlaps[f * work.methods.size() + m];
      sum.common += one.common;
      sum.both += one.both;
      if (m + 1 == work.methods.size() && (result.worst < 0 || one.Dice() < result.least))
      {
        result.least = one.Dice();
        result.worst = plan[f].target->slice;
      }
    }
    result.dice[static_cast<std::size_t>(work.methods[m])] = sum.Dice();
  }
  return result;
}

} // namespace lamina
