// SPDX-License-Identifier: BSD-3-Clause
// Swapping an edge for the other diagonal.
#include "EditCorners.h"
#include "EditableSurface.h"

#include <algorithm>

namespace lamina
{

bool EditableSurface::Swap(Id a, Id b)
{
  const EdgeTriangles shared = this->TrianglesAt(a, b);
  if (this->IsFeature(shared))
  {
    return false;
  }
  // Let the first triangle run a -> b.
  const Triangle first = this->Corners(shared[0]);
  if (Others(first, a)[0] != b)
  {
    std::swap(a, b);
  }
  const Id c = Third(first, a, b);
  const Id d = Third(this->Corners(shared[1]), a, b);
  if (c == d || !this->TrianglesAt(c, d).empty())
  {
    return false;
  }
  const double worst = std::min(this->Quality(shared[0]), this->Quality(shared[1]));
  const double least = this->Mending ? std::min(0.3, worst) : worst * 1.01;
  const double q = std::min(this->Quality({ { a, d, c } }), this->Quality({ { d, b, c } }));
  if (q < least)
  {
    return false;
  }
  Edit& edit = this->Work.edit;
  this->RemoveTriangles(edit, shared);
  edit.leastQuality = least;
  this->Add(edit, { a, d, c }, shared[0]);
  this->Add(edit, { d, b, c }, shared[1]);
  edit.added[0].before = edit.added[1].before =
    Normalized(AreaVector2(this->Points, first) + AreaVector2(this->Points, this->Corners(shared[1])));
  if (!this->IsSound(edit))
  {
    return false;
  }
  this->Commit(edit);
  ++this->Done.swaps;
  return true;
}

} // namespace lamina
