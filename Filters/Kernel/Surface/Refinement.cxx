// SPDX-License-Identifier: BSD-3-Clause
#include "Refinement.h"

#include <algorithm>

namespace lamina
{

template<typename Visit>
void Refinement::ForEdges(Id since, Visit&& visit) const
{
  const auto isNew = [&](Id t) { return this->Surface.ChangedAt(t) > since; };
  for (Id t = 0; t < this->Surface.TriangleCount(); ++t)
  {
    if (!this->Surface.IsAlive(t) || !isNew(t))
    {
      continue;
    }
    const Triangle corners = this->Surface.Corners(t);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id a = corners[k];
      const Id b = corners[(k + 1) % 3];
      // Each edge once: from the changed triangle with the least id.
      const EdgeTriangles at = this->Surface.TrianglesAt(a, b);
      if (std::none_of(at.begin(), at.end(), [&](Id other) { return other < t && isNew(other); }))
      {
        visit(std::min(a, b), std::max(a, b));
      }
    }
  }
}

void Refinement::SplitLong()
{
  EdgeQueue queue;
  this->ForEdges(this->Split,
                 [&](Id a, Id b)
                 {
                   const double r = this->Surface.RelativeLength(a, b);
                   if (r > this->Options.splitRatio)
                   {
                     queue.push({ r, a, b });
                   }
                 });
  this->Split = this->Surface.Clock();
  while (!queue.empty() && !this->Stopped())
  {
    const RankedEdge edge = queue.top();
    queue.pop();
    if (!this->Surface.TrianglesAt(edge.a, edge.b).empty())
    {
      this->SplitAlongPath(edge.a, edge.b, queue);
    }
  }
}

/// Rivara's longest-edge path: an edge is bisected only when it is the longest of all its triangles; before
/// that the longer ones are, so that no angle falls below half of what it was.
void Refinement::SplitAlongPath(Id a, Id b, EdgeQueue& queue)
{
  Id u = a;
  Id v = b;
  for (bool longer = true; longer;)
  {
    longer = false;
    double longest = this->Surface.Length(u, v) * (1 + 1e-9);
    for (Id t : this->Surface.TrianglesAt(u, v))
    {
      const Triangle c = this->Surface.Corners(t);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Id p = std::min(c[k], c[(k + 1) % 3]);
        const Id q = std::max(c[k], c[(k + 1) % 3]);
        if (this->Surface.Length(p, q) > longest)
        {
          longest = this->Surface.Length(p, q) * (1 + 1e-9);
          u = p;
          v = q;
          longer = true;
        }
      }
    }
  }
  const Id middle = this->Surface.Split(u, v);
  std::vector<Id> ends;
  for (Id t : this->Surface.Star(middle))
  {
    for (Id p : this->Surface.Corners(t))
    {
      if (p != middle)
      {
        ends.push_back(p);
      }
    }
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (Id p : ends)
  {
    const double r = this->Surface.RelativeLength(p, middle);
    if (r > this->Options.splitRatio)
    {
      queue.push({ r, std::min(p, middle), std::max(p, middle) });
    }
  }
  if (!(u == a && v == b))
  {
    queue.push({ this->Surface.RelativeLength(a, b), a, b }); // its turn comes again
  }
}

void Refinement::MergeShort()
{
  EdgeQueue queue; // the highest rank first: the shortest edge
  const auto offer = [&](Id a, Id b)
  {
    const double r = this->Surface.RelativeLength(a, b);
    if (r < this->Options.mergeRatio)
    {
      queue.push({ -r, std::min(a, b), std::max(a, b) });
    }
  };
  const Id now = this->Surface.Clock();
  this->ForEdges(this->Merged, offer);
  this->Merged = now;
  while (!queue.empty() && !this->Stopped())
  {
    const RankedEdge edge = queue.top();
    queue.pop();
    if (this->Surface.TrianglesAt(edge.a, edge.b).empty() ||
        this->Surface.RelativeLength(edge.a, edge.b) >= this->Options.mergeRatio ||
        !this->Surface.Merge(edge.a, edge.b))
    {
      continue;
    }
    const Id kept = this->Surface.Star(edge.a).empty() ? edge.b : edge.a;
    std::vector<Id> ends;
    for (Id t : this->Surface.Star(kept))
    {
      const Triangle& c = this->Surface.Corners(t);
      ends.insert(ends.end(), c.begin(), c.end());
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for (Id p : ends)
    {
      if (p != kept)
      {
        offer(kept, p);
      }
    }
  }
}

void Refinement::SwapAll()
{
  for (int pass = 0; pass < 4; ++pass)
  {
    std::vector<std::pair<Id, Id>> edges;
    const Id now = this->Surface.Clock();
    this->ForEdges(this->Swapped, [&](Id a, Id b) { edges.push_back({ a, b }); });
    this->Swapped = now;
    bool swapped = false;
    for (const auto& edge : edges)
    {
      if (this->Stopped())
      {
        return;
      }
      swapped = (this->Surface.TrianglesAt(edge.first, edge.second).size() == 2 &&
                 this->Surface.Swap(edge.first, edge.second)) ||
                swapped;
    }
    if (!swapped)
    {
      break;
    }
  }
}

void Refinement::RelaxAll()
{
  for (Id p = 0; p < this->Surface.PointCount() && !this->Stopped(); ++p)
  {
    this->Surface.Relax(p);
  }
}

void Refinement::KeepOrder()
{
  constexpr Id growth = 4; // a quarter more: what was split lies far from its neighbours in memory
  if ((growth + 1) * this->Ordered < growth * this->Surface.TriangleCount())
  {
    this->Surface.Renumber();
    this->Ordered = this->Surface.TriangleCount();
  }
}

bool Refinement::Iterate()
{
  this->KeepOrder();
  this->MergeShort();
  this->SplitLong();
  this->KeepOrder();
  this->SwapAll();
  this->RelaxAll();
  this->SwapAll();
  this->RelaxAll();
  return !this->Watch.Cancelled();
}

} // namespace lamina
