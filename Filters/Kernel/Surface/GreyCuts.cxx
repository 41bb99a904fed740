// SPDX-License-Identifier: BSD-3-Clause
#include "GreyCuts.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

namespace
{

std::size_t At(Id i)
{
  return static_cast<std::size_t>(i);
}

/// The grey values on the low and on the high side of a face inside the image.
std::array<double, 2> GreyBeside(const VoxelFace& face, const GreyView& grey)
{
  const auto low = face.LowVoxel();
  return { grey.At(grey.grid.Index(low[0], low[1], low[2])),
           grey.At(grey.grid.Index(face.corner[0], face.corner[1], face.corner[2])) };
}

/// Sobel's differences, along the grid's axes; beyond the border, and where nothing is known, the values go
/// on.
Vec3 GradientAt(const std::array<Id, 3>& voxel, const GreyView& grey)
{
  const double centre = grey.At(grey.grid.Index(voxel[0], voxel[1], voxel[2]));
  Vec3 gradient;
  for (Id n = 0; n < 27; ++n)
  {
    const std::array<Id, 3> step{ n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1 };
    std::array<Id, 3> at;
    double weight = 1;
    for (std::size_t c = 0; c < 3; ++c)
    {
      at[c] = std::clamp<Id>(voxel[c] + step[c], 0, grey.grid.size[c] - 1);
      weight *= step[c] == 0 ? 2 : 1;
    }
    const double value = grey.At(grey.grid.Index(at[0], at[1], at[2]));
    const double difference = weight * ((std::isfinite(value) ? value : centre) - centre);
    gradient += difference * Vec3{ static_cast<double>(step[0]), static_cast<double>(step[1]),
                                   static_cast<double>(step[2]) };
  }
  const Vec3& spacing = grey.grid.spacing;
  return { gradient.x / spacing.x, gradient.y / spacing.y, gradient.z / spacing.z };
}

/// The intervals of grey values that the faces of one pair part.
struct Intervals
{
  std::vector<double> from;
  std::vector<double> to;

  void Add(double a, double b)
  {
    this->from.push_back(a);
    this->to.push_back(b);
  }
  /// The middle of where most of them overlap.
  double Deepest();
};

double Intervals::Deepest()
{
  std::sort(this->from.begin(), this->from.end());
  std::sort(this->to.begin(), this->to.end());
  double value = 0;
  std::size_t most = 0;
  std::size_t ended = 0;
  for (std::size_t n = 0; n < this->from.size(); ++n)
  {
    while (this->to[ended] <= this->from[n])
    {
      ++ended;
    }
    if (n + 1 - ended > most)
    {
      most = n + 1 - ended;
      value = 0.5 * (this->from[n] + this->to[ended]);
    }
  }
  return value;
}

} // namespace

std::map<MaterialPair, double> FindCutValues(const std::vector<VoxelFace>& faces, const GreyView& grey)
{
  // Of each pair those whose lower id is the darker, and the others: the larger party counts.
  std::map<MaterialPair, std::array<Intervals, 2>> pairs;
  for (const VoxelFace& face : faces)
  {
    if (!face.MayMove())
    {
      continue;
    }
    const auto beside = GreyBeside(face, grey);
    const double ofLower = face.low < face.high ? beside[0] : beside[1];
    const double ofHigher = face.low < face.high ? beside[1] : beside[0];
    if (std::isfinite(ofLower) && std::isfinite(ofHigher) && ofLower != ofHigher)
    {
      const MaterialPair pair{ std::min(face.low, face.high), std::max(face.low, face.high) };
      pairs[pair][ofLower < ofHigher ? 0 : 1].Add(std::min(ofLower, ofHigher), std::max(ofLower, ofHigher));
    }
  }
  std::map<MaterialPair, double> values;
  for (auto& [pair, parties] : pairs)
  {
    Intervals& larger = parties[parties[1].from.size() > parties[0].from.size() ? 1 : 0];
    values[pair] = larger.Deepest();
  }
  return values;
}

std::vector<GreyCut> FindGreyCuts(const std::vector<VoxelFace>& faces, const GreyView& grey, Monitor& monitor)
{
  const std::map<MaterialPair, double> values = FindCutValues(faces, grey);
  std::vector<GreyCut> cuts(faces.size());
  monitor.For(
    static_cast<Id>(faces.size()), 8192,
    [&](Id begin, Id end)
    {
      for (Id f = begin; f < end; ++f)
      {
        const VoxelFace& face = faces[At(f)];
        const auto value = values.find({ std::min(face.low, face.high), std::max(face.low, face.high) });
        if (!face.MayMove() || value == values.end())
        {
          continue;
        }
        const auto beside = GreyBeside(face, grey);
        const double along = (value->second - beside[0]) / (beside[1] - beside[0]);
        const Vec3 normal = Normalized(GradientAt(face.LowVoxel(), grey) + GradientAt(face.corner, grey));
        if (along > 0 && along < 1 && Norm2(normal) > 0.5)
        {
          cuts[At(f)] = { true, along - 0.5, normal };
        }
      }
    });
  return cuts;
}

} // namespace lamina
