// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeColours.h"

#include <algorithm>
#include <cstdint>

namespace lamina
{

namespace
{

constexpr int colours = 192;

using Mask = std::array<std::uint64_t, colours / 64>;

} // namespace

std::vector<Relaxable> ChooseEdges(const SmoothingState& s)
{
  const auto kind = [&](Id p) { return s.surface.junctionKind[static_cast<std::size_t>(p)]; };
  std::vector<Relaxable> chosen;
  std::vector<char> served(s.surface.points.size(), 0);
  for (std::size_t e = 0; e < s.table.edges.size(); ++e)
  {
    const Edge& edge = s.table.edges[e];
    const bool sheet = (kind(edge.a) & 3) == JunctionSheet;
    const bool curve = (kind(edge.a) & 3) == JunctionCurve && s.feature[e];
    if (kind(edge.a) == kind(edge.b) && (sheet || curve) &&
        s.freedom[static_cast<std::size_t>(edge.a)].dimensions > 1)
    {
      chosen.push_back(static_cast<Id>(e));
      served[static_cast<std::size_t>(edge.a)] = 1;
      served[static_cast<std::size_t>(edge.b)] = 1;
    }
  }
  for (std::size_t p = 0; p < served.size(); ++p)
  {
    if (!served[p] && (kind(static_cast<Id>(p)) & 3) != JunctionCorner &&
        s.star.Count(static_cast<Id>(p)) > 0)
    {
      chosen.push_back(-1 - static_cast<Id>(p));
    }
  }
  return chosen;
}

std::vector<std::vector<Relaxable>> ColourEdges(const SmoothingState& s, const std::vector<Relaxable>& chosen)
{
  std::vector<Mask> written(s.surface.points.size(), Mask{});
  std::vector<Mask> read(s.surface.points.size(), Mask{});
  std::vector<std::vector<Relaxable>> classes(colours);
  std::vector<Id> reach;
  std::vector<Id> reachedBy(s.surface.points.size(), 0); // the number of the edge, from 1
  Id number = 0;
  for (const Relaxable which : chosen)
  {
    const Edge edge = EndsOf(s, which);
    ++number;
    reach.clear();
    for (Id end : { edge.a, edge.b })
    {
      if (end < 0)
      {
        continue;
      }
      for (Id q : Row(s.ring, end))
      {
        for (const Id r : Row(s.ring, q))
        {
          Id& last = reachedBy[static_cast<std::size_t>(r)];
          if (last != number)
          {
            last = number;
            reach.push_back(r);
          }
        }
      }
    }
    int colour = -1;
    for (std::size_t w = 0; w < Mask{}.size() && colour < 0; ++w)
    {
      std::uint64_t taken = 0;
      for (Id p : reach)
      {
        taken |= written[static_cast<std::size_t>(p)][w];
      }
      for (Id end : { edge.a, edge.b })
      {
        taken |= end < 0 ? 0 : read[static_cast<std::size_t>(end)][w];
      }
      if (~taken != 0)
      {
        int bit = 0;
        while (taken >> bit & 1)
        {
          ++bit;
        }
        colour = static_cast<int>(64 * w) + bit;
      }
    }
    if (colour < 0)
    {
      // More than `colours` edges meet here: such an edge waits in a class of its own.
      classes.push_back({ which });
      continue;
    }
    const auto word = static_cast<std::size_t>(colour / 64);
    const std::uint64_t flag = std::uint64_t{ 1 } << (colour % 64);
    for (Id p : reach)
    {
      read[static_cast<std::size_t>(p)][word] |= flag;
    }
    for (Id end : { edge.a, edge.b })
    {
      if (end >= 0)
      {
        written[static_cast<std::size_t>(end)][word] |= flag;
      }
    }
    classes[static_cast<std::size_t>(colour)].push_back(which);
  }
  classes.erase(std::remove_if(classes.begin(), classes.end(), [](const auto& c) { return c.empty(); }),
                classes.end());
  return classes;
}

} // namespace lamina
