// SPDX-License-Identifier: BSD-3-Clause
#include "GradientLimit.h"

#include <algorithm>
#include <limits>

namespace lamina
{
namespace
{

constexpr std::size_t LeafSize = 8;
constexpr Id Grain = 1024;

struct Sample
{
  Vec3 place;
  double value;
};

/// A balanced tree over samples, each node with its box and the least value below it: a node whose least
/// value plus the way to its box is above what is known already need not be opened.
class LeastValueTree
{
public:
  explicit LeastValueTree(std::vector<Sample>& samples)
    : Samples(samples)
  {
    this->Nodes.reserve(samples.size() / LeafSize * 4 + 1);
    this->Build(0, samples.size());
  }

  /// The least of value + gradient * distance over all samples that is below `bound`, else `bound`.
  double Least(const Vec3& p, double gradient, double bound) const
  {
    struct Step
    {
      std::size_t node;
      double least;
    };
    std::array<Step, 128> stack;
    std::size_t top = 0;
    stack[top++] = { 0, this->Floor(0, p, gradient) };
    while (top > 0)
    {
      const Step step = stack[--top];
      if (step.least >= bound)
      {
        continue;
      }
      const Node& node = this->Nodes[step.node];
      for (std::size_t i = node.begin; i < node.end; ++i)
      {
        bound = std::min(bound, this->Samples[i].value + gradient * Norm(p - this->Samples[i].place));
      }
      if (node.right != 0)
      {
        Step near{ step.node + 1, this->Floor(step.node + 1, p, gradient) };
        Step far{ node.right, this->Floor(node.right, p, gradient) };
        if (far.least < near.least)
        {
          std::swap(near, far);
        }
        stack[top++] = far;
        stack[top++] = near;
      }
    }
    return bound;
  }

private:
  struct Node
  {
    Vec3 low;
    Vec3 high;
    double least = std::numeric_limits<double>::infinity();
    std::size_t begin = 0; ///< range of samples, leaves only
    std::size_t end = 0;
    std::size_t right = 0; ///< the left child follows its parent; leaves: 0
  };

  /// A lower bound of what any sample below the node can give; a trifle lower, to be safe from rounding.
  double Floor(std::size_t index, const Vec3& p, double gradient) const
  {
    const Node& node = this->Nodes[index];
    double sum = 0;
    for (int i = 0; i < 3; ++i)
    {
      const double d = std::max({ node.low[i] - p[i], 0.0, p[i] - node.high[i] });
      sum += d * d;
    }
    return (node.least + gradient * std::sqrt(sum)) * (1 - 1e-14);
  }

  /// Depth is the logarithm of the number of samples: halves by the median.
  std::size_t Build(std::size_t begin, std::size_t end)
  {
    const std::size_t index = this->Nodes.size();
    this->Nodes.emplace_back();
    Node node;
    node.low = node.high = this->Samples[begin].place;
    for (std::size_t i = begin; i < end; ++i)
    {
      node.least = std::min(node.least, this->Samples[i].value);
      for (int k = 0; k < 3; ++k)
      {
        node.low[k] = std::min(node.low[k], this->Samples[i].place[k]);
        node.high[k] = std::max(node.high[k], this->Samples[i].place[k]);
      }
    }
    if (end - begin <= LeafSize)
    {
      node.begin = begin;
      node.end = end;
    }
    else
    {
      const Vec3 e = node.high - node.low;
      const int axis = e.x >= e.y && e.x >= e.z ? 0 : (e.y >= e.z ? 1 : 2);
      const std::size_t middle = begin + (end - begin) / 2;
      const auto at = [this](std::size_t i)
      { return this->Samples.begin() + static_cast<std::ptrdiff_t>(i); };
      std::nth_element(at(begin), at(middle), at(end),
                       [axis](const Sample& a, const Sample& b) { return a.place[axis] < b.place[axis]; });
      this->Build(begin, middle);
      node.right = this->Build(middle, end);
    }
    this->Nodes[index] = node;
    return index;
  }

  std::vector<Sample>& Samples;
  std::vector<Node> Nodes;
};

} // namespace

void LimitGradient(const std::vector<Vec3>& points, const std::vector<Id>& ids, double gradient,
                   std::vector<double>& values, Monitor& monitor)
{
  if (ids.empty())
  {
    return;
  }
  std::vector<Sample> samples(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    samples[i] = { points[static_cast<std::size_t>(ids[i])], values[i] };
  }
  const LeastValueTree tree(samples);
  monitor.For(static_cast<Id>(ids.size()), Grain,
              [&](Id begin, Id end)
              {
                for (Id i = begin; i < end; ++i)
                {
                  double& value = values[static_cast<std::size_t>(i)];
                  const Vec3& place = points[static_cast<std::size_t>(ids[static_cast<std::size_t>(i)])];
                  // The point's own sample never falls under this bound, and neither do falls that are mere
                  // rounding.
                  const double bound = value * (1 - 1e-13);
                  const double least = tree.Least(place, gradient, bound);
                  value = least < bound ? least : value;
                }
              });
}

} // namespace lamina
