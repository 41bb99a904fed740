// SPDX-License-Identifier: BSD-3-Clause
#include "MaskCarrying.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

/// What two drawn slices, either of which may be missing, look like from a slice between them.
std::vector<CarriedSource> SourcesOf(const CarryWork& work, Id slice, const DrawnSlice* low,
                                     const SliceField* toLow, const DrawnSlice* high,
                                     const SliceField* toHigh)
{
  std::vector<CarriedSource> sources;
  const auto add = [&](const DrawnSlice* drawn, const SliceField* field, const DrawnSlice* other)
  {
    const double weight = other ? static_cast<double>(std::abs(other->slice - slice)) /
                                    static_cast<double>(std::abs(other->slice - drawn->slice))
                                : 1.0;
    sources.push_back({ drawn, work.Grey(drawn->slice), field, static_cast<float>(weight), other });
  };
  if (low)
  {
    add(low, toLow, high);
  }
  if (high)
  {
    add(high, toHigh, low);
  }
  return sources;
}

void RegisterGap(const CarryWork& work, const MaskGap& gap, GapFields& fields, Monitor& monitor)
{
  const Id begin = gap.Begin();
  const Id pairs = gap.End() - begin;
  const auto at = [](std::vector<SliceField>& all, Id k) -> SliceField&
  { return all[static_cast<std::size_t>(k)]; };
  const SliceField still = NoDisplacement(work.grid.width, work.grid.height);
  fields.toLow.resize(gap.low >= 0 ? static_cast<std::size_t>(pairs) + 1 : 0, still);
  fields.toHigh.resize(gap.high >= 0 ? static_cast<std::size_t>(pairs) + 1 : 0, still);
  const Id low = gap.low >= 0 ? pairs : 0;
  const Id high = gap.high >= 0 ? pairs : 0;
  monitor.For(low + high, 1,
              [&](Id from, Id to)
              {
                for (Id t = from; t < to; ++t)
                {
                  const bool down = t < low;
                  const Id k = down ? t + 1 : t - low;
                  const Id neighbour = down ? k - 1 : k + 1;
                  at(down ? fields.toLow : fields.toHigh, k) = RegisterSlices(
                    *work.Grey(begin + k), *work.Grey(begin + neighbour), work.grid.shape, work.registration);
                }
              });
  if (monitor.Cancelled())
  {
    return;
  }
  monitor.For(2, 1,
              [&](Id from, Id to)
              {
                for (Id side = from; side < to; ++side)
                {
                  for (Id k = 1; k <= pairs && side == 0 && low > 0; ++k)
                  {
                    at(fields.toLow, k) = Compose(at(fields.toLow, k), at(fields.toLow, k - 1), *work.warper);
                  }
                  for (Id k = pairs - 1; k >= 0 && side == 1 && high > 0; --k)
                  {
                    at(fields.toHigh, k) =
                      Compose(at(fields.toHigh, k), at(fields.toHigh, k + 1), *work.warper);
                  }
                }
              });
}

void FillGap(const CarryWork& work, const MaskGap& gap, const GapFields& fields, GapSlices& slices,
             Monitor& monitor)
{
  const std::size_t count = static_cast<std::size_t>(gap.last - gap.first + 1);
  for (const CarryMethod method : work.methods)
  {
    slices.labels[static_cast<std::size_t>(method)].resize(count);
    slices.residuals[static_cast<std::size_t>(method)].resize(count);
  }
  const Id tries = static_cast<Id>(work.methods.size());
  monitor.For(static_cast<Id>(count) * tries, 1,
              [&](Id from, Id to)
              {
                for (Id t = from; t < to; ++t)
                {
                  const std::size_t n = static_cast<std::size_t>(t / tries);
                  const Id slice = gap.first + static_cast<Id>(n);
                  const std::size_t k = static_cast<std::size_t>(slice - gap.Begin());
                  const CarryMethod method = work.methods[static_cast<std::size_t>(t % tries)];
                  const CarriedSlice carried = CarryToSlice(
                    work.grid, work.Grey(slice), work.stack.noise,
                    SourcesOf(work, slice, work.Drawn(gap.low),
                              fields.toLow.empty() ? nullptr : &fields.toLow[k], work.Drawn(gap.high),
                              fields.toHigh.empty() ? nullptr : &fields.toHigh[k]),
                    work.ids, method, *work.warper);
                  const std::size_t m = static_cast<std::size_t>(method);
                  slices.labels[m][n].assign(carried.labels.begin(), carried.labels.end());
                  slices.residuals[m][n] = carried.residual;
                }
              });
}

} // namespace lamina
