// SPDX-License-Identifier: BSD-3-Clause
#include "SliceStack.h"

#include "Specks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamina
{

namespace
{

constexpr float Surroundings = 10;       ///< pixels around a drawn region that count for contrast and noise
constexpr double LeastNoise = 0.01;      ///< of the contrast
constexpr std::size_t Samples = 2000000; ///< that are looked at, at most

/// The one place where grey values are read.
double GreyAt(const GreyImage& grey, Id voxel)
{
  return grey.values[static_cast<std::size_t>(voxel)];
}

double Quantile(std::vector<double>& values, double share)
{
  const auto place =
    values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// Every so many pixels in and around the regions of the drawn slices, in order.
template<typename Visit>
void VisitSurroundings(const SliceGrid& grid, const std::vector<DrawnSlice>& drawn, Visit&& visit)
{
  std::size_t count = 0;
  const auto each = [&](auto&& use)
  {
    for (const DrawnSlice& slice : drawn)
    {
      for (Id p = 0; !slice.empty && p < grid.width * grid.height; ++p)
      {
        if (slice.distances[0].values[static_cast<std::size_t>(p)] > -Surroundings)
        {
          use(slice.slice, p % grid.width, p / grid.width);
        }
      }
    }
  };
  each([&](Id, Id, Id) { ++count; });
  const std::size_t stride = count / Samples + 1;
  std::size_t number = 0;
  each(
    [&](Id slice, Id x, Id y)
    {
      if (number++ % stride == 0)
      {
        visit(slice, x, y);
      }
    });
}

/// Grey values 0 and 1: the range of all but the outermost hundredths, or the whole range if those agree.
void FindRange(const SliceGrid& grid, const GreyImage& grey, const std::vector<DrawnSlice>& drawn,
               SliceStack& stack)
{
  std::vector<double> values;
  VisitSurroundings(grid, drawn,
                    [&](Id slice, Id x, Id y)
                    {
                      const double value = GreyAt(grey, grid.Voxel(slice, x, y));
                      if (std::isfinite(value))
                      {
                        values.push_back(value);
                      }
                    });
  if (values.empty())
  {
    return;
  }
  stack.low = Quantile(values, 0.01);
  stack.high = Quantile(values, 0.99);
  if (!(stack.high > stack.low))
  {
    const auto ends = std::minmax_element(values.begin(), values.end());
    stack.low = *ends.first;
    stack.high = *ends.second;
  }
}

/// By the median difference between a pixel and the mean of its four neighbours, which edges hardly move.
double MeasureNoise(const SliceGrid& grid, const std::vector<DrawnSlice>& drawn, const SliceStack& stack)
{
  std::vector<double> differences;
  VisitSurroundings(grid, drawn,
                    [&](Id slice, Id x, Id y)
                    {
                      const SliceImage& s = stack.slices[static_cast<std::size_t>(slice)];
                      if (s.Count() > 0 && x > 0 && y > 0 && x + 1 < grid.width && y + 1 < grid.height)
                      {
                        const float mean =
                          0.25F * (s.At(x - 1, y) + s.At(x + 1, y) + s.At(x, y - 1) + s.At(x, y + 1));
                        differences.push_back(std::abs(s.At(x, y) - mean));
                      }
                    });
  constexpr double medianOfNormal = 0.6745;
  const double spread = std::sqrt(1.25) * medianOfNormal;
  return differences.empty() ? LeastNoise : std::max(LeastNoise, Quantile(differences, 0.5) / spread);
}

void MeasureDistances(const SliceGrid& grid, const std::vector<int>& ids, DrawnSlice& slice)
{
  const auto region = [&](auto&& belongs)
  {
    std::vector<unsigned char> inside(slice.labels.size());
    std::transform(slice.labels.begin(), slice.labels.end(), inside.begin(),
                   [&](int label) { return belongs(label) ? 1 : 0; });
    slice.distances.push_back(SignedDistance(inside, grid.width, grid.height, grid.shape));
    const std::vector<float>& values = slice.distances.back().values;
    slice.depths.push_back(std::max(0.0F, *std::max_element(values.begin(), values.end())));
  };
  region([](int label) { return label != 0; });
  for (std::size_t i = 0; ids.size() > 1 && i < ids.size(); ++i)
  {
    region([&](int label) { return label == ids[i]; });
  }
}

} // namespace

SliceGrid::SliceGrid(const GridGeometry& grid, int across)
  : size(grid.size)
  , axis(across)
{
  const std::size_t x = across == 0 ? 1 : 0;
  const std::size_t y = across == 2 ? 1 : 2;
  this->width = grid.size[x];
  this->height = grid.size[y];
  this->slices = grid.size[static_cast<std::size_t>(across)];
  this->shape = MakePixelShape(grid.spacing[static_cast<int>(x)], grid.spacing[static_cast<int>(y)]);
}

Id SliceGrid::Voxel(Id slice, Id x, Id y) const
{
  const std::array<Id, 3> index = this->axis == 0   ? std::array<Id, 3>{ { slice, x, y } }
                                  : this->axis == 1 ? std::array<Id, 3>{ { x, slice, y } }
                                                    : std::array<Id, 3>{ { x, y, slice } };
  return index[0] + this->size[0] * (index[1] + this->size[1] * index[2]);
}

DrawnSlice ReadDrawnSlice(const SliceGrid& grid, const LabelImage& mask, const std::vector<int>& ids,
                          Id slice)
{
  DrawnSlice drawn;
  drawn.slice = slice;
  drawn.labels.resize(static_cast<std::size_t>(grid.width * grid.height));
  for (Id p = 0; p < grid.width * grid.height; ++p)
  {
    const int label =
      mask.labels[static_cast<std::size_t>(grid.Voxel(slice, p % grid.width, p / grid.width))];
    const bool wanted = std::binary_search(ids.begin(), ids.end(), label);
    drawn.labels[static_cast<std::size_t>(p)] = wanted ? label : 0;
    drawn.empty = drawn.empty && !wanted;
  }
  MeasureDistances(grid, ids, drawn);
  drawn.smallest = SmallestParts(drawn.labels, grid.width, ids);
  return drawn;
}

DrawnSlice EmptySlice(const SliceGrid& grid, const std::vector<int>& ids, Id slice)
{
  DrawnSlice empty;
  empty.slice = slice;
  empty.assumed = true;
  empty.labels.assign(static_cast<std::size_t>(grid.width * grid.height), 0);
  MeasureDistances(grid, ids, empty);
  empty.smallest = SmallestParts(empty.labels, grid.width, ids);
  return empty;
}

SliceStack ReadSliceStack(const SliceGrid& grid, const GreyImage& grey, const std::vector<DrawnSlice>& drawn,
                          Id from, Id to, Monitor& monitor)
{
  SliceStack stack;
  stack.slices.resize(static_cast<std::size_t>(grid.slices));
  FindRange(grid, grey, drawn, stack);
  if (stack.IsConstant())
  {
    return stack;
  }
  monitor.For(to - from, 1,
              [&](Id begin, Id end)
              {
                for (Id k = from + begin; k < from + end; ++k)
                {
                  SliceImage slice(grid.width, grid.height);
                  for (Id p = 0; p < slice.Count(); ++p)
                  {
                    const double value = GreyAt(grey, grid.Voxel(k, p % grid.width, p / grid.width));
                    const double share = (value - stack.low) / (stack.high - stack.low);
                    slice.values[static_cast<std::size_t>(p)] =
                      std::isnan(share) ? 0.0F : static_cast<float>(std::min(1.0, std::max(0.0, share)));
                  }
                  stack.slices[static_cast<std::size_t>(k)] = std::move(slice);
                }
              });
  if (!monitor.Cancelled())
  {
    stack.noise = MeasureNoise(grid, drawn, stack);
  }
  return stack;
}

} // namespace lamina
