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
  /// `maySplit`: where nothing else helps, make the edges at a hidden node shorter.
  void UncoverNodes(bool maySplit);

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
  bool SplitBeside(Id p);
  /// Give the surface an order of space again once it has grown.
  void KeepOrder();
  bool Stopped() { return ++this->Ticks % 4096 == 0 && this->Watch.Cancelled(); }

  EditableSurface& Surface;
  const RefineSurfaceOptions& Options;
  Monitor& Watch;
  Id Ticks = 0;
  Id Ordered = 0; ///< triangles when the surface was last put in order
  // The clock of the surface when all edges were last looked at.
  Id Merged = -1;
  Id Split = -1;
  Id Swapped = -1;
};

} // namespace lamina
