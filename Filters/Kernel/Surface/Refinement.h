// SPDX-License-Identifier: BSD-3-Clause
// The rounds of a refinement: which edits are tried where, and in which order.
#pragma once

#include "EditableSurface.h"
#include "RefineSurface.h"

#include <queue>
#include <utility>

namespace lamina
{

struct RankedEdge
{
  double rank;
  Id a;
  Id b;
};
/// The top of the queue is the highest rank; ties go to the lower ids, so that the order is always the same.
struct Before
{
  bool operator()(const RankedEdge& e, const RankedEdge& f) const
  {
    return e.rank != f.rank ? e.rank < f.rank : (e.a != f.a ? e.a > f.a : e.b > f.b);
  }
};
using EdgeQueue = std::priority_queue<RankedEdge, std::vector<RankedEdge>, Before>;

/// How hidden nodes are uncovered.
struct Uncovering
{
  double from = 0.5;     ///< nodes whose faces are seen worse than this are worked on at first
  double enough = 0.41;  ///< and then until all see this well
  double gain = 0.04;    ///< share of what blocks the sight that an edit must take away
  double shortest = 0.9; ///< edges shorter than this, in their target, are not split
  int mostSplits = 0;    ///< at a node, where nothing else helps: shorter edges can bend further
  /// Work only on what was left the last time, and split no more at a node whose last split did not help.
  bool onlyLeft = false;
  double leastQuality = 0; ///< of what splits make
};
/// Before the rounds, after them, and for the few that then are hidden still: there edges may get short.
constexpr Uncovering uncoverFirst{};
constexpr Uncovering uncoverLast{ 0.5, 0.41, 0.04, 0.9, 4 };
constexpr Uncovering uncoverStubborn{ 0.401, 0.41, 0.005, 0.7, 12, true, 0.2 };

/// Edits one surface in rounds, in an order that depends on the surface alone.
class Refinement
{
public:
  Refinement(EditableSurface& surface, const RefineSurfaceOptions& options, Monitor& monitor)
    : Surface(surface)
    , Options(options)
    , Watch(monitor)
  {
  }
  bool Iterate();
  void MendShapes();
  void UncoverNodes(const Uncovering& how);

private:
  /// Visits each edge with a triangle that has changed since the clock stood at `since`, once.
  template<typename Visit>
  void ForEdges(Id since, Visit&& visit) const;
  void SplitLong();
  void SplitAlongPath(Id a, Id b, EdgeQueue& queue);
  void MergeShort();
  /// Calls offer(p, q) for the points q that share a triangle with p.
  template<typename Offer>
  void OfferAround(Id p, const Offer& offer) const;
  void SwapAll();
  void RelaxAll();
  bool SplitBeside(Id p, const Uncovering& how);
  /// Give the surface an order of space again once it has grown.
  void KeepOrder();
  bool Stopped() { return ++this->Ticks % 4096 == 0 && this->Watch.Cancelled(); }

  EditableSurface& Surface;
  const RefineSurfaceOptions& Options;
  Monitor& Watch;
  Id Ticks = 0;
  std::vector<Id> LeftHidden; ///< nodes that UncoverNodes worked on to the end
  Id Ordered = 0;             ///< triangles when the surface was last put in order
  // The clock of the surface when all edges were last looked at.
  Id Merged = -1;
  Id Split = -1;
  Id Swapped = -1;
};

} // namespace lamina
