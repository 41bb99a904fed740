// SPDX-License-Identifier: BSD-3-Clause
// When an edit of a surface is sound: shapes, distance to the input, intersections, visibility of nodes.
#include "EditableSurface.h"

#include "../Geometry/Predicates.h"
#include "../Geometry/Quality.h"

#include <algorithm>

namespace lamina
{

namespace
{

constexpr double leastTurnCosine = 0.5; ///< between the normal of a triangle and that of the one it replaces

} // namespace

bool EditableSurface::IsSound(const Edit& edit) const
{
  bool allVisible = true;
  return this->HasGoodShapes(edit) && this->KeepsNodesVisible(edit, allVisible) && this->IsNearInput(edit) &&
         this->IsClearOfOthers(edit) && (allVisible || this->IsClearOfItself(edit));
}

bool EditableSurface::HasGoodShapes(const Edit& edit) const
{
  for (const Added& t : edit.added)
  {
    const Vec3& a = this->Point(t.corners[0]);
    const Vec3& b = this->Point(t.corners[1]);
    const Vec3& c = this->Point(t.corners[2]);
    const Vec3 area = Cross(b - a, c - a);
    if ((!this->Mending && Dot(area, t.normal) < leastTurnCosine * Norm(area)) ||
        !(TriangleQuality(a, b, c) >= edit.leastQuality))
    {
      return false;
    }
  }
  return !edit.added.empty();
}

/// Middles and edges of the new triangles lie near the input. Around a common corner each spoke is the first
/// edge of one triangle, and the edges opposite to it are old.
bool EditableSurface::IsNearInput(const Edit& edit) const
{
  const double least = this->Mending ? 0.5 * this->Input.MeanEdge() : 0;
  for (const Added& t : edit.added)
  {
    const Vec3& a = this->Point(t.corners[0]);
    const Vec3& b = this->Point(t.corners[1]);
    const Vec3& c = this->Point(t.corners[2]);
    if (!this->Input.IsNear(t.sheet, (1.0 / 3) * (a + b + c), least))
    {
      return false;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const bool test = edit.centre < 0 || t.corners[k] == edit.centre;
      if (test && !this->Input.IsNear(
                    t.sheet, 0.5 * (this->Point(t.corners[k]) + this->Point(t.corners[(k + 1) % 3])), least))
      {
        return false;
      }
    }
  }
  return true;
}

/// No new triangle meets any other but in shared corners and edges.
bool EditableSurface::IsClearOfOthers(const Edit& edit) const
{
  for (const Added& t : edit.added)
  {
    const Box box = this->BoxOf(t.corners);
    const bool clear =
      this->Grid.ForNear(box,
                         [&](Id other)
                         {
                           return std::binary_search(edit.removed.begin(), edit.removed.end(), other) ||
                                  !box.Overlaps(this->BoxOf(this->Corners(other))) ||
                                  !TrianglesIntersect(this->Points, t.corners, this->Corners(other));
                         });
    if (!clear)
    {
      return false;
    }
  }
  return true;
}

/// The new triangles do not meet one another either. Where a direction sees all faces of every node they
/// cannot.
bool EditableSurface::IsClearOfItself(const Edit& edit) const
{
  for (std::size_t i = 0; i < edit.added.size(); ++i)
  {
    for (std::size_t j = i + 1; j < edit.added.size(); ++j)
    {
      if (TrianglesIntersect(this->Points, edit.added[i].corners, edit.added[j].corners))
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace lamina
