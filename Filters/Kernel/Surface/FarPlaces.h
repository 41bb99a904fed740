// SPDX-License-Identifier: BSD-3-Clause
// Where a refined surface and its input lie farther apart than the tolerance.
#pragma once

#include "InputSurface.h"

namespace lamina
{

/// Looks at a whole surface both ways, at more places than the edits do.
class FarPlaces
{
public:
  /// `surface` and `sheets` (in the numbers of the input) must outlive this; points may move between calls.
  FarPlaces(const TriangleComplex& surface, const SheetGraph& sheets, const InputSurface& input);
  /// The triangles, ascending, that lie too far from the input or that a place of the input lies too far
  /// from.
  std::vector<Id> Find(Monitor& monitor);

private:
  bool IsFar(Id triangle) const;
  /// The triangle of the surface nearest to the places of a triangle of the input that are too far off, or
  /// -1.
  Id FarFrom(Id inputTriangle) const;

  const TriangleComplex& Surface;
  const SheetGraph& Sheets;
  const InputSurface& Input;
  SheetTrees Trees; ///< of the surface
};

} // namespace lamina
