// SPDX-License-Identifier: BSD-3-Clause
// Where the front of a wall's columns meets itself or comes too near, asked again and again while it moves.
#pragma once

#include "../Base/Monitor.h"
#include "../Search/TriangleTree.h"
#include "Wall.h"

#include <utility>

namespace lamina
{

/// Keeps the front from question to question. After the first only what can have another answer than before
/// is looked at, so the one who asks must have dealt with every answer: what was found to intersect has moved
/// before the next question, and what was found too near has moved or never will.
class FrontCheck
{
public:
  explicit FrontCheck(const Wall& wall)
    : W(wall)
    , Front(wall.points)
    , Edge(wall.points.size(), 0)
    , Gap(wall.points.size(), 0)
    , Tree(this->Front, wall.triangles)
  {
  }
  FrontCheck(const FrontCheck&) = delete;
  FrontCheck& operator=(const FrontCheck&) = delete;

  /// The front stands here now; everything is new at the first call.
  void Move(const std::vector<Vec3>& points, Monitor& monitor);
  /// Points of triangles that changed by the last move, ascending: those whose Edge may be another.
  const std::vector<Id>& Touched() const { return this->Points; }
  /// Mean length of the front's edges at a point.
  double EdgeAt(Id v) const { return this->Edge[static_cast<std::size_t>(v)]; }
  /// How far from other parts of the front the triangles at a point should be.
  void SetGap(Id v, double gap) { this->Gap[static_cast<std::size_t>(v)] = gap; }
  double GapAt(Id v) const { return this->Gap[static_cast<std::size_t>(v)]; }

  /// The points of triangles that intersect others, ascending.
  std::vector<Id> Intersecting(Monitor& monitor) const;
  /// Points whose triangles are nearer to another without a common corner than their gap, and how near.
  std::vector<std::pair<Id, double>> TooNear(Monitor& monitor) const;

private:
  void MarkChanged(const std::vector<Vec3>& points);
  /// Triangles whose distance to others may have changed: those at touched points, and those that a changed
  /// one is near to.
  std::vector<Id> Suspects(Monitor& monitor) const;
  double CutoffOf(Id triangle) const;

  const Wall& W;
  std::vector<Vec3> Front;
  std::vector<double> Edge;
  std::vector<double> Gap;
  TriangleTree Tree;
  std::vector<Id> Changed; ///< triangles with a corner that the last move displaced, ascending
  std::vector<Id> Points;  ///< their corners
  bool IsNew = true;
};

} // namespace lamina
