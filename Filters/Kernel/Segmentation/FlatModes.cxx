// SPDX-License-Identifier: BSD-3-Clause
#include "FlatModes.h"

#include "Histogram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numeric>

namespace lamina
{

namespace
{

constexpr int Bins = 256;
/// The most that two neighbours of a flat voxel differ by, of the range; where it finds fewer than three
/// modes, as things of few voxels have none that flat, twice as much.
constexpr double Flat = 0.06;
constexpr double LessFlat = 0.12;
/// The deviation, in bins, that the histogram is smoothed with, and how far that reaches.
constexpr double Width = 2;
constexpr int Reach = 8;
/// A valley at most this part of a peak makes it one, if it is no chance.
constexpr double Valley = 0.6;
/// What of the height of a peak is its top.
constexpr double Top = 0.7;
constexpr double Chances = 3;
constexpr double FewestVoxels = 8;
constexpr double LeastShare = 0.001;
/// How far from background to tissue their threshold lies: not half way, as the peak of thin walls is drawn
/// towards what is brighter beside them.
constexpr double ToTissue = 0.47;
/// What of the way from tissue to blood may be either.
constexpr double DisputedFrom = 0.4;
constexpr double DisputedTo = 0.6;

using Counts = std::vector<double>;

/// A row of the image with the four rows around it; at the border the row itself stands for what is missing.
class FlatRow
{
public:
  FlatRow(const GreyView& grey)
    : Grey(grey)
  {
    for (auto& row : this->Rows)
    {
      row.resize(static_cast<std::size_t>(grey.grid.size[0]));
    }
  }
  void Read(Id j, Id k)
  {
    const auto& size = this->Grey.grid.size;
    const std::array<std::array<Id, 2>, 5> places{ { { j, k },
                                                     { std::max<Id>(j - 1, 0), k },
                                                     { std::min(j + 1, size[1] - 1), k },
                                                     { j, std::max<Id>(k - 1, 0) },
                                                     { j, std::min(k + 1, size[2] - 1) } } };
    for (std::size_t r = 0; r < places.size(); ++r)
    {
      const Id first = this->Grey.grid.Index(0, places[r][0], places[r][1]);
      this->Grey.Read(first, first + size[0], this->Rows[r].data());
    }
  }
  double At(std::size_t i) const { return this->Rows[0][i]; }
  /// False beside values that are no numbers.
  bool IsFlat(std::size_t i, double most) const
  {
    const auto& own = this->Rows[0];
    const double before = own[i > 0 ? i - 1 : i];
    const double after = own[i + 1 < own.size() ? i + 1 : i];
    return std::abs(after - before) <= most && std::abs(this->Rows[2][i] - this->Rows[1][i]) <= most &&
           std::abs(this->Rows[4][i] - this->Rows[3][i]) <= most;
  }

private:
  const GreyView& Grey;
  std::array<std::vector<double>, 5> Rows;
};

/// The histogram of the flat voxels. Sums of whole numbers: the same for any number of threads.
Counts CountFlat(const GreyView& grey, const GreyRange& range, double flat, Monitor& monitor)
{
  const auto& size = grey.grid.size;
  const double most = flat * (range.greatest - range.least);
  std::vector<Id> counts(Bins, 0);
  std::mutex guard;
  monitor.For(size[1] * size[2], 64,
              [&](Id begin, Id end)
              {
                FlatRow row(grey);
                std::vector<Id> own(Bins, 0);
                for (Id r = begin; r < end; ++r)
                {
                  row.Read(r % size[1], r / size[1]);
                  for (std::size_t i = 0; i < static_cast<std::size_t>(size[0]); ++i)
                  {
                    if (range.Holds(row.At(i)) && row.IsFlat(i, most))
                    {
                      ++own[static_cast<std::size_t>(range.BinOf(row.At(i), Bins))];
                    }
                  }
                }
                const std::lock_guard<std::mutex> lock(guard);
                std::transform(own.begin(), own.end(), counts.begin(), counts.begin(), std::plus<Id>());
              });
  return Counts(counts.begin(), counts.end());
}

Counts SmoothCounts(const Counts& counts)
{
  std::array<double, 2 * Reach + 1> weights{};
  double all = 0;
  for (int d = -Reach; d <= Reach; ++d)
  {
    const double weight = std::exp(-0.5 * d * d / (Width * Width));
    weights[static_cast<std::size_t>(d + Reach)] = weight;
    all += weight;
  }
  Counts smooth(Bins, 0);
  for (int b = 0; b < Bins; ++b)
  {
    for (int d = std::max(-Reach, -b); d <= std::min(Reach, Bins - 1 - b); ++d)
    {
      smooth[static_cast<std::size_t>(b)] +=
        weights[static_cast<std::size_t>(d + Reach)] / all * counts[static_cast<std::size_t>(b + d)];
    }
  }
  return smooth;
}

/// Hills of the histogram, joined from the top down: where two meet the lower one counts as a peak of its own
/// if it stands high enough above the place.
class Hills
{
public:
  explicit Hills(const Counts& heights)
    : Heights(heights)
    , Peak(Bins, -1)
  {
    std::vector<int> order(Bins);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return this->Height(a) > this->Height(b); });
    for (const int bin : order)
    {
      if (this->Height(bin) > 0)
      {
        this->Add(bin);
      }
    }
    for (const int bin : order)
    {
      if (this->Peak[static_cast<std::size_t>(bin)] == bin)
      {
        this->Peaks.push_back(bin); // of hills that met no higher one
      }
    }
    std::sort(this->Peaks.begin(), this->Peaks.end());
  }
  std::vector<int> Peaks; ///< bins, ascending

private:
  double Height(int bin) const { return this->Heights[static_cast<std::size_t>(bin)]; }
  /// The peak of the hill that a bin belongs to; -1 if none does yet.
  int PeakOf(int bin) const
  {
    int peak = bin >= 0 && bin < Bins ? this->Peak[static_cast<std::size_t>(bin)] : -1;
    while (peak >= 0 && this->Peak[static_cast<std::size_t>(peak)] != peak)
    {
      peak = this->Peak[static_cast<std::size_t>(peak)];
    }
    return peak;
  }
  void Add(int bin)
  {
    int higher = this->PeakOf(bin - 1);
    int lower = this->PeakOf(bin + 1);
    if (higher < 0 || (lower >= 0 && this->Height(lower) > this->Height(higher)))
    {
      std::swap(higher, lower);
    }
    this->Peak[static_cast<std::size_t>(bin)] = higher < 0 ? bin : higher;
    if (lower < 0)
    {
      return;
    }
    // A smoothed bin is a mean over 2 sqrt(pi) Width bins or so, and varies less than a count does.
    const double chance = std::sqrt(this->Height(lower) / (3.54 * Width));
    const double depth = this->Height(lower) - this->Height(bin);
    if (this->Height(bin) <= Valley * this->Height(lower) && depth > Chances * chance)
    {
      this->Peaks.push_back(lower);
    }
    this->Peak[static_cast<std::size_t>(lower)] = higher;
  }

  const Counts& Heights;
  std::vector<int> Peak;
};

/// The voxels of each peak, up to the lowest places between it and its neighbours.
Counts VoxelsOf(const std::vector<int>& peaks, const Counts& counts, const Counts& smooth)
{
  Counts voxels;
  auto from = counts.begin();
  for (std::size_t p = 0; p < peaks.size(); ++p)
  {
    auto to = counts.end();
    if (p + 1 < peaks.size())
    {
      to = counts.begin() +
           (std::min_element(smooth.begin() + peaks[p], smooth.begin() + peaks[p + 1]) - smooth.begin());
    }
    voxels.push_back(std::accumulate(from, to, 0.0));
    from = to;
  }
  return voxels;
}

/// The middle, in bins, of the top of a peak: steadier than its highest bin where it has few voxels. The top
/// ends above any valley that parts two peaks.
double MiddleOf(int peak, const Counts& heights)
{
  const auto high = [&](int b)
  {
    return b >= 0 && b < Bins &&
           heights[static_cast<std::size_t>(b)] >= Top * heights[static_cast<std::size_t>(peak)];
  };
  int from = peak;
  int to = peak + 1;
  for (; high(from - 1); --from)
  {
  }
  for (; high(to); ++to)
  {
  }
  double all = 0;
  double moment = 0;
  for (int b = from; b < to; ++b)
  {
    all += heights[static_cast<std::size_t>(b)];
    moment += heights[static_cast<std::size_t>(b)] * (b + 0.5);
  }
  return moment / all;
}

std::vector<double> ModesOf(const Counts& counts, const GreyRange& range)
{
  const Counts heights = SmoothCounts(counts);
  std::vector<int> peaks = Hills(heights).Peaks;
  const double fewest =
    std::max(FewestVoxels, LeastShare * std::accumulate(counts.begin(), counts.end(), 0.0));
  while (peaks.size() > 1)
  {
    const Counts voxels = VoxelsOf(peaks, counts, heights);
    const auto fewestOf = std::min_element(voxels.begin(), voxels.end());
    if (*fewestOf >= fewest)
    {
      break;
    }
    peaks.erase(peaks.begin() + (fewestOf - voxels.begin()));
  }
  std::vector<double> modes;
  for (const int peak : peaks)
  {
    modes.push_back(range.ValueOf(MiddleOf(peak, heights), Bins));
  }
  return modes;
}

} // namespace

std::vector<double> FlatModes(const GreyView& smooth, double least, double greatest, Monitor& monitor)
{
  const GreyRange range = WithoutTails(smooth, { least, greatest }, monitor);
  const std::vector<double> modes = ModesOf(CountFlat(smooth, range, Flat, monitor), range);
  if (modes.size() > 2 || monitor.Cancelled())
  {
    return modes;
  }
  const std::vector<double> more = ModesOf(CountFlat(smooth, range, LessFlat, monitor), range);
  return more.size() > modes.size() ? more : modes;
}

std::vector<double> ModeThresholds(const std::vector<double>& modes)
{
  const std::size_t count = modes.size();
  if (count < 2)
  {
    return {};
  }
  if (count == 2)
  {
    return { modes[0] + ToTissue * (modes[1] - modes[0]) };
  }
  const double tissue = modes[count - 2];
  const double toBlood = modes[count - 1] - tissue;
  return { modes[count - 3] + ToTissue * (tissue - modes[count - 3]), tissue + DisputedFrom * toBlood,
           tissue + DisputedTo * toBlood };
}

} // namespace lamina
