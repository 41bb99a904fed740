// SPDX-License-Identifier: BSD-3-Clause
// Cutting a surface along a plane, and the plane ends that close it again.
#pragma once

#include "../Mesh/TriangleComplex.h"
#include "PlaneSection.h"

#include <optional>

namespace lamina
{

/// A plane end: its triangles are the last ones of a cut surface.
struct PlaneEnd
{
  int material = 0;
  Id firstTriangle = 0;
  Id triangles = 0;
};

struct CutSurface
{
  TriangleComplex surface; ///< points may be unused
  std::vector<PlaneEnd> ends;
};

/// Cut the triangles for which `region` is not 0 along the plane, drop their parts above it, and close the
/// surface by plane ends. Points are moved into the plane where an edge would be cut within `snap` of its
/// length from them. Nothing if the ends are no simple regions: a smaller `snap` may help.
std::optional<CutSurface> CutAlongPlane(const TriangleComplex& surface, const PlaneFrame& frame,
                                        const std::vector<double>& heights, const std::vector<char>& region,
                                        double snap);

} // namespace lamina
