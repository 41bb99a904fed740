// SPDX-License-Identifier: BSD-3-Clause
// When an edit of a surface is sound: shapes, distance to the input, intersections, visibility of nodes.
#include "EditableSurface.h"

#include "../Geometry/Predicates.h"
#include "EditCorners.h"

#include <algorithm>
#include <limits>

namespace lamina
{

namespace
{

constexpr double leastTurnCosine = 0.5; ///< between the normal of a triangle and that of the one it replaces

} // namespace

bool EditableSurface::IsSound(Edit& edit) const
{
  bool allVisible = true;
  return this->HasGoodShapes(edit) && this->KeepsNodesVisible(edit, allVisible) && this->IsNearInput(edit) &&
         this->KeepsInputNear(edit) && this->IsClearOfOthers(edit, allVisible) &&
         (allVisible || this->IsClearOfItself(edit)) && this->OpensWide(edit, allVisible);
}

bool EditableSurface::HasGoodShapes(Edit& edit) const
{
  edit.boxes.clear();
  for (Added& t : edit.added)
  {
    const Vec3& a = this->Point(t.corners[0]);
    const Vec3& b = this->Point(t.corners[1]);
    const Vec3& c = this->Point(t.corners[2]);
    t.normal = Normalized(Cross(b - a, c - a));
    edit.boxes.push_back(this->BoxOf(t.corners));
    if ((!this->Mending && Dot(t.normal, t.before) < leastTurnCosine) ||
        !(this->Quality(t.corners) >= edit.leastQuality))
    {
      return false;
    }
  }
  return !edit.added.empty();
}

/// The new triangles lie near the input: looked at in the middle, at two places from there to each corner,
/// and at three places of each edge. Around a common corner the edges opposite to it are old.
bool EditableSurface::IsNearInput(Edit& edit) const
{
  for (Added& t : edit.added)
  {
    const Vec3 corners[3] = { this->Point(t.corners[0]), this->Point(t.corners[1]),
                              this->Point(t.corners[2]) };
    const Vec3 middle = (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
    if (!this->Input.IsNear(t.sheet, middle, t.hint))
    {
      return false;
    }
    Id hint = t.hint;
    const auto isNear = [&](const Vec3& place) { return this->Input.IsNear(t.sheet, place, hint); };
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vec3& from = corners[k];
      const Vec3& to = corners[(k + 1) % 3];
      const bool isNew = edit.centre < 0 || t.corners[k] == edit.centre;
      if (!isNear(0.5 * (middle + from)) || !isNear(0.75 * middle + 0.25 * from) ||
          (isNew && !(isNear(0.5 * (from + to)) && isNear(0.75 * from + 0.25 * to) &&
                      isNear(0.25 * from + 0.75 * to))))
      {
        return false;
      }
    }
  }
  // The centre lies near each of its sheets: looked at once a run of triangles of the same one.
  int sheet = -1;
  for (const Added& t : edit.added)
  {
    Id hint = t.hint;
    if (edit.centre >= 0 && t.sheet != sheet && !this->Input.IsNear(t.sheet, this->Point(edit.centre), hint))
    {
      return false;
    }
    sheet = t.sheet;
  }
  return true;
}

double EditableSurface::PlaceSamples(Edit& edit) const
{
  double worst = 0;
  for (Id t : edit.removed)
  {
    for (int sample = this->Samples.First(t); sample >= 0; sample = this->Samples.Next(sample))
    {
      const Vec3& place = this->Samples.Place(sample);
      SampleOwner owner{ sample, -1 };
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < edit.added.size(); ++i)
      {
        const Added& added = edit.added[i];
        Vec3 closest;
        std::array<double, 3> weights;
        if (added.sheet != this->Sheets[static_cast<std::size_t>(t)] ||
            edit.boxes[i].Distance2(place) >= nearest)
        {
          continue;
        }
        const double d2 =
          PointTriangleDistance2(place, this->Point(added.corners[0]), this->Point(added.corners[1]),
                                 this->Point(added.corners[2]), closest, weights);
        if (d2 < nearest)
        {
          nearest = d2;
          owner.added = static_cast<int>(i);
        }
      }
      const double tolerance = this->Samples.Tolerance(sample);
      worst = std::max(worst, nearest / (tolerance * tolerance));
      edit.owners.push_back(owner);
    }
  }
  return worst;
}

/// The points of the input that lie on what is removed lie near what is added.
bool EditableSurface::KeepsInputNear(Edit& edit) const
{
  edit.owners.clear();
  return this->PlaceSamples(edit) <= 1;
}

/// No new triangle meets any other but in shared corners and edges, nor comes near to one that it faces.
bool EditableSurface::IsClearOfOthers(const Edit& edit, bool allVisible) const
{
  double target = this->Target(edit.added[0].corners[0]);
  for (const Added& t : edit.added)
  {
    target = std::min(
      { target, this->Target(t.corners[0]), this->Target(t.corners[1]), this->Target(t.corners[2]) });
  }
  const double reach = this->Input.LeastGap(target);
  return this->Grid.ForNear(edit.boxes, reach,
                            [&](std::size_t i, Id other)
                            {
                              if (std::binary_search(edit.removed.begin(), edit.removed.end(), other))
                              {
                                return true;
                              }
                              const Added& t = edit.added[i];
                              const Triangle& theirs = this->Corners(other);
                              for (Id p : theirs)
                              {
                                if (Has(t.corners, p))
                                {
                                  // Seen from where all faces at p show, those of one sheet lie side by side.
                                  return (allVisible && this->Classes[U(p)] == OnSheet) ||
                                         !TrianglesIntersect(this->Points, t.corners, theirs);
                                }
                              }
                              const double apart2 = edit.boxes[i].Distance2(this->BoxOf(theirs));
                              return (apart2 > 0 || !TrianglesIntersect(this->Points, t.corners, theirs)) &&
                                     (apart2 >= reach * reach || this->StaysApart(t, other, reach));
                            });
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
