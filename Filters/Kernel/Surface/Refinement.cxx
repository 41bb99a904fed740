// SPDX-License-Identifier: BSD-3-Clause
#include "Refinement.h"

#include "EditBatch.h"

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
  EditBatch<RankedEdge> batch(this->Surface, this->Watch);
  std::vector<RankedEdge> later; // too near to one that is shorter
  while (!queue.empty() && !this->Watch.Cancelled())
  {
    while (!queue.empty() && !batch.IsFull() && later.size() < batch.Most)
    {
      const RankedEdge edge = queue.top();
      queue.pop();
      if (!this->Surface.TrianglesAt(edge.a, edge.b).empty() &&
          this->Surface.RelativeLength(edge.a, edge.b) < this->Options.mergeRatio &&
          !batch.Offer(edge, this->Surface.RegionOf(edge.a, edge.b)))
      {
        later.push_back(edge);
      }
    }
    batch.Run([this](const RankedEdge& edge, EditPlan& plan)
              { this->Surface.PlanMerge(edge.a, edge.b, false, plan); },
              [&](const RankedEdge&, const EditPlan& plan) { this->OfferAround(plan.edit.moved, offer); });
    for (const RankedEdge& edge : later)
    {
      queue.push(edge);
    }
    later.clear();
  }
}

template<typename Offer>
void Refinement::OfferAround(Id p, const Offer& offer) const
{
  std::vector<Id> ends;
  for (Id t : this->Surface.Star(p))
  {
    const Triangle& c = this->Surface.Corners(t);
    ends.insert(ends.end(), c.begin(), c.end());
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (Id q : ends)
  {
    if (q != p)
    {
      offer(p, q);
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

/// Neighbours in number are neighbours in space: a batch takes its points from far apart, and the next one
/// those after them.
void Refinement::RelaxAll()
{
  constexpr Id pointsPerStream = 32; // at least
  const Id count = this->Surface.PointCount();
  const Id streams = std::clamp<Id>(count / pointsPerStream, 1, EditBatch<Id>::Most);
  const Id length = (count + streams - 1) / streams;
  EditBatch<Id> batch(this->Surface, this->Watch);
  std::vector<Id> waiting;
  std::vector<Id> later;
  for (Id i = 0; (i < length || !waiting.empty()) && !this->Watch.Cancelled(); ++i)
  {
    for (Id p = i; p < count && i < length; p += length)
    {
      waiting.push_back(p);
    }
    for (Id p : waiting)
    {
      if (this->Surface.MayRelax(p) && (batch.IsFull() || !batch.Offer(p, this->Surface.RegionOf(p))))
      {
        later.push_back(p);
      }
    }
    batch.Run([this](Id p, EditPlan& plan) { this->Surface.PlanRelax(p, plan); }, [](Id, const EditPlan&) {});
    waiting.swap(later);
    later.clear();
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
