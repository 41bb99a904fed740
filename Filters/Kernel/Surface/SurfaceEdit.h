// SPDX-License-Identifier: BSD-3-Clause
// A change of a surface: triangles that go, triangles that come, and what has to be known of them.
#pragma once

#include "InputSamples.h"

namespace lamina
{

struct SurfaceEdit
{
  /// A triangle that comes.
  struct Added
  {
    Triangle corners;
    int sheet;
    Vec3 before; ///< unit normal of what it replaces
    Id hint;     ///< a triangle of the input near it, or -1
    Vec3 normal; ///< its own unit normal
  };

  std::vector<Id> removed; ///< ascending
  std::vector<Added> added;
  std::vector<Box> boxes;          ///< of what is added
  double leastQuality = 0;         ///< no added triangle may be worse
  Id centre = -1;                  ///< the corner that all added triangles share, if there is one
  Id moved = -1;                   ///< the point that the edit moves, if there is one
  Vec3 from;                       ///< where it was
  std::vector<SampleOwner> owners; ///< of the input's samples on the removed triangles
};

/// An edit that was looked at, to be carried out later if it is sound.
struct EditPlan
{
  SurfaceEdit edit;
  bool isSound = false;
  Vec3 place;        ///< where the point edit.moved comes to lie
  double target = 0; ///< of that point
  Stretch stretch;   ///< the same
  Id gone = -1;      ///< a point that is merged into it, or -1
};

/// What an edit may look at and change.
struct EditRegion
{
  Box writes;
  Box reads;
};

} // namespace lamina
