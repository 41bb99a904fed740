// SPDX-License-Identifier: BSD-3-Clause
#include "PatchVotes.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

namespace
{

constexpr float Band = 8;            ///< pixels from the blended border in which patches vote
constexpr float Reach = 3;           ///< pixels from which a patch is taken
constexpr float Likeness = 4;        ///< mean squared difference of patches that counts little, in variances
constexpr float PriorReach = 3;      ///< pixels from the border at which the prior is fully sure
constexpr float PriorWeight = 0.25F; ///< of the blended distance against the vote
constexpr float VoteBlur = 0.7F;     ///< pixels

/// Pixels [x0, x1) x [y0, y1).
struct Box
{
  Id x0 = 0;
  Id x1 = 0;
  Id y0 = 0;
  Id y1 = 0;

  bool IsEmpty() const { return this->x0 >= this->x1 || this->y0 >= this->y1; }
};

/// For each region, the pixels that not all sources put far to the same side of its border.
std::vector<std::vector<char>> FindContested(const std::vector<Carried>& carried)
{
  std::vector<std::vector<char>> contested;
  for (std::size_t r = 0; r < carried.front().distances.size(); ++r)
  {
    contested.emplace_back(carried.front().distances[r].values.size());
    for (std::size_t p = 0; p < contested[r].size(); ++p)
    {
      float least = Band;
      float greatest = -Band;
      for (const Carried& source : carried)
      {
        least = std::min(least, source.distances[r].values[p]);
        greatest = std::max(greatest, source.distances[r].values[p]);
      }
      contested[r][p] = least < Band && greatest > -Band;
    }
  }
  return contested;
}

Box BoxOf(const std::vector<std::vector<char>>& contested, Id width)
{
  Box box{ width, 0, static_cast<Id>(contested.front().size()) / width, 0 };
  for (const std::vector<char>& pixels : contested)
  {
    for (std::size_t p = 0; p < pixels.size(); ++p)
    {
      if (pixels[p])
      {
        const Id x = static_cast<Id>(p) % width;
        const Id y = static_cast<Id>(p) / width;
        box = { std::min(box.x0, x), std::max(box.x1, x + 1), std::min(box.y0, y), std::max(box.y1, y + 1) };
      }
    }
  }
  return box;
}

float MedianDifference(const SliceImage& a, const SliceImage& b, const Box& box)
{
  std::vector<float> differences;
  for (Id y = box.y0; y < box.y1; ++y)
  {
    for (Id x = box.x0; x < box.x1; ++x)
    {
      differences.push_back(a.At(x, y) - b.At(x, y));
    }
  }
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  return *middle;
}

/// Votes of all patches at one offset from their pixels.
class OffsetVotes
{
public:
  OffsetVotes(const SliceImage& target, const Carried& source, float brightness, const Box& box)
    : Target(target)
    , Source(source)
    , Brightness(brightness)
    , Around(box)
    , Width(box.x1 - box.x0)
    , Height(box.y1 - box.y0)
    , Squares(static_cast<std::size_t>((Width + 2) * (Height + 2)))
    , Rows(static_cast<std::size_t>(Width * (Height + 2)))
  {
  }

  /// Add weight x side of the border to `votes` and the weight to `total`, for the patches (dx, dy) away.
  void Add(Id dx, Id dy, float nearness, float likeness, std::vector<SliceImage>& votes, SliceImage& total)
  {
    this->MeasureSquares(dx, dy);
    for (Id y = 0; y < this->Height; ++y)
    {
      for (Id x = 0; x < this->Width; ++x)
      {
        const std::size_t r = static_cast<std::size_t>(x + this->Width * y);
        const std::size_t step = static_cast<std::size_t>(this->Width);
        const float mean = (this->Rows[r] + this->Rows[r + step] + this->Rows[r + 2 * step]) / 9;
        const float weight = nearness * std::exp(-mean / likeness);
        const std::size_t from = this->Clamped(x + this->Around.x0 + dx, y + this->Around.y0 + dy);
        const std::size_t to =
          static_cast<std::size_t>(x + this->Around.x0 + this->Target.width * (y + this->Around.y0));
        total.values[to] += weight;
        for (std::size_t v = 0; v < votes.size(); ++v)
        {
          const float side = std::min(1.0F, std::max(-1.0F, this->Source.distances[v].values[from]));
          votes[v].values[to] += weight * side;
        }
      }
    }
  }

private:
  std::size_t Clamped(Id x, Id y) const
  {
    const Id i = std::min(std::max<Id>(0, x), this->Target.width - 1);
    const Id j = std::min(std::max<Id>(0, y), this->Target.height - 1);
    return static_cast<std::size_t>(i + this->Target.width * j);
  }

  /// Squared differences, and their sums over three neighbours in a row.
  void MeasureSquares(Id dx, Id dy)
  {
    const Id wide = this->Width + 2;
    for (Id y = 0; y < this->Height + 2; ++y)
    {
      for (Id x = 0; x < wide; ++x)
      {
        const Id i = x + this->Around.x0 - 1;
        const Id j = y + this->Around.y0 - 1;
        const float d = this->Target.values[this->Clamped(i, j)] - this->Brightness -
                        this->Source.grey.values[this->Clamped(i + dx, j + dy)];
        this->Squares[static_cast<std::size_t>(x + wide * y)] = d * d;
      }
      for (Id x = 0; x < this->Width; ++x)
      {
        const float* s = &this->Squares[static_cast<std::size_t>(x + wide * y)];
        this->Rows[static_cast<std::size_t>(x + this->Width * y)] = s[0] + s[1] + s[2];
      }
    }
  }

  const SliceImage& Target;
  const Carried& Source;
  float Brightness;
  Box Around;
  Id Width;
  Id Height;
  std::vector<float> Squares;
  std::vector<float> Rows;
};

/// For each region, how far the like patches lie inside (to 1) or outside (to -1); 0 where nothing is alike.
std::vector<SliceImage> Vote(const SliceGrid& grid, const SliceImage& target, double noise,
                             const std::vector<Carried>& carried, const Box& box)
{
  std::vector<SliceImage> votes(carried.front().distances.size(), SliceImage(grid.width, grid.height));
  SliceImage total(grid.width, grid.height);
  const float likeness = Likeness * static_cast<float>(noise * noise);
  const Id reachX = static_cast<Id>(Reach / grid.shape.x);
  const Id reachY = static_cast<Id>(Reach / grid.shape.y);
  for (const Carried& source : carried)
  {
    OffsetVotes offset(target, source, MedianDifference(target, source.grey, box), box);
    for (Id dy = -reachY; dy <= reachY; ++dy)
    {
      for (Id dx = -reachX; dx <= reachX; ++dx)
      {
        const float ax = static_cast<float>(dx) * grid.shape.x;
        const float ay = static_cast<float>(dy) * grid.shape.y;
        const float square = (ax * ax + ay * ay) / (Reach * Reach);
        if (square <= 1)
        {
          offset.Add(dx, dy, source.weight * std::exp(-square), likeness, votes, total);
        }
      }
    }
  }
  for (SliceImage& vote : votes)
  {
    for (std::size_t p = 0; p < total.values.size(); ++p)
    {
      vote.values[p] /= std::max(total.values[p], 1e-12F);
    }
    vote = Blur(vote, VoteBlur, grid.shape);
  }
  return votes;
}

/// Replace distances by votes and a bit of themselves where the side is contested; elsewhere they are sure.
void Correct(std::vector<SliceImage>& distances, const std::vector<SliceImage>& votes,
             const std::vector<std::vector<char>>& contested)
{
  for (std::size_t r = 0; r < distances.size(); ++r)
  {
    for (std::size_t p = 0; p < distances[r].values.size(); ++p)
    {
      float& d = distances[r].values[p];
      const float sure = std::min(1.0F, std::max(-1.0F, d / PriorReach));
      d = contested[r][p] ? PriorWeight * sure + votes[r].values[p] : 2 * sure;
    }
  }
}

} // namespace

void CorrectByPatches(const SliceGrid& grid, const SliceImage& target, double noise,
                      const std::vector<Carried>& carried, std::vector<SliceImage>& blended)
{
  const std::vector<std::vector<char>> contested = FindContested(carried);
  const Box box = BoxOf(contested, grid.width);
  if (!box.IsEmpty())
  {
    Correct(blended, Vote(grid, target, noise, carried, box), contested);
  }
}

} // namespace lamina
