// SPDX-License-Identifier: BSD-3-Clause
#include "CarriedSlice.h"

#include "PatchVotes.h"
#include "Specks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace lamina
{

namespace
{

constexpr Id LeastPart = 5;         ///< pixels
constexpr float ResidualMargin = 3; ///< pixels around the regions where slices are compared

Carried Carry(const CarriedSource& source, CarryMethod method, const SliceWarper& warper)
{
  std::vector<const SliceImage*> drawn;
  if (source.grey)
  {
    drawn.push_back(source.grey);
  }
  for (const SliceImage& distance : source.drawn->distances)
  {
    drawn.push_back(&distance);
  }
  Carried carried;
  carried.weight = source.weight;
  if (method == CarryMethod::Shape)
  {
    std::transform(drawn.begin(), drawn.end(), std::back_inserter(carried.distances),
                   [](const SliceImage* image) { return *image; });
  }
  else
  {
    carried.distances = warper.Pull(drawn, *source.field);
  }
  if (source.grey)
  {
    carried.grey = std::move(carried.distances.front());
    carried.distances.erase(carried.distances.begin());
  }
  for (std::size_t r = 0; r < carried.distances.size(); ++r)
  {
    if (source.other && source.drawn->depths[r] <= 0 && source.other->depths[r] > 0) // it shrinks
    {
      std::vector<float>& values = carried.distances[r].values;
      std::fill(values.begin(), values.end(), -source.other->depths[r]);
    }
  }
  return carried;
}

std::vector<SliceImage> Blend(const std::vector<Carried>& carried)
{
  std::vector<SliceImage> blended;
  for (std::size_t r = 0; r < carried.front().distances.size(); ++r)
  {
    SliceImage sum(carried.front().distances[r].width, carried.front().distances[r].height);
    for (const Carried& one : carried)
    {
      for (std::size_t p = 0; p < sum.values.size(); ++p)
      {
        sum.values[p] += one.weight * one.distances[r].values[p];
      }
    }
    blended.push_back(std::move(sum));
  }
  return blended;
}

double MeasureResidual(const SliceImage& target, const std::vector<Carried>& carried,
                       const SliceImage& distance)
{
  double sum = 0;
  double count = 0;
  for (std::size_t p = 0; p < distance.values.size(); ++p)
  {
    if (distance.values[p] > -ResidualMargin)
    {
      double grey = 0;
      for (const Carried& source : carried)
      {
        grey += static_cast<double>(source.weight) * static_cast<double>(source.grey.values[p]);
      }
      sum += std::abs(static_cast<double>(target.values[p]) - grey);
      ++count;
    }
  }
  return count > 0 ? sum / count : 0;
}

std::vector<int> ChooseLabels(const std::vector<SliceImage>& distances, const std::vector<int>& ids)
{
  std::vector<int> labels(distances.front().values.size(), 0);
  for (std::size_t p = 0; p < labels.size(); ++p)
  {
    if (!(distances.front().values[p] > 0))
    {
      continue;
    }
    std::size_t best = 0;
    for (std::size_t r = 1; r < ids.size(); ++r)
    {
      best = distances[r + 1].values[p] > distances[best + 1].values[p] ? r : best;
    }
    labels[p] = ids[best];
  }
  return labels;
}

/// The smallest islands and holes are noise, unless the drawn slices have some as small.
void CleanUp(const SliceGrid& grid, const std::vector<CarriedSource>& sources, const std::vector<int>& ids,
             std::vector<int>& labels)
{
  std::vector<Id> least(ids.size() + 1, LeastPart);
  for (const CarriedSource& source : sources)
  {
    for (std::size_t r = 0; r < least.size(); ++r)
    {
      least[r] = std::min(least[r], source.drawn->smallest[r]);
    }
  }
  RemoveSpecks(labels, grid.width, ids, least);
}

} // namespace

CarriedSlice CarryToSlice(const SliceGrid& grid, const SliceImage* grey, double noise,
                          const std::vector<CarriedSource>& sources, const std::vector<int>& ids,
                          CarryMethod method, const SliceWarper& warper)
{
  std::vector<Carried> carried;
  for (const CarriedSource& source : sources)
  {
    carried.push_back(Carry(source, method, warper));
  }
  std::vector<SliceImage> distances = Blend(carried);
  CarriedSlice result;
  if (grey)
  {
    result.residual = MeasureResidual(*grey, carried, distances.front());
  }
  if (method == CarryMethod::GreyValues)
  {
    CorrectByPatches(grid, *grey, noise, carried, distances);
  }
  result.labels = ChooseLabels(distances, ids);
  if (method == CarryMethod::GreyValues)
  {
    CleanUp(grid, sources, ids, result.labels);
  }
  return result;
}

} // namespace lamina
