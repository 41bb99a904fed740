// SPDX-License-Identifier: BSD-3-Clause
#include "CoreTetsInput.h"

#include "../Mesh/Closedness.h"
#include "../Search/SelfIntersection.h"

#include <algorithm>

namespace lamina
{

std::optional<Error> CheckCoreOptions(const CoreTetsOptions& o)
{
  // Written so that NaN fails.
  if (!(o.radiusEdgeRatio >= 1.2 && o.radiusEdgeRatio <= 100))
  {
    return InvalidOption("radiusEdgeRatio is " + std::to_string(o.radiusEdgeRatio) +
                         ", but must be in [1.2, 100]");
  }
  if (!(o.sizeFactor > 0 && std::isfinite(o.sizeFactor)))
  {
    return InvalidOption("sizeFactor is " + std::to_string(o.sizeFactor) + ", but must be above 0");
  }
  if (!(o.maximumEdge >= 0 && std::isfinite(o.maximumEdge)))
  {
    return InvalidOption("maximumEdge is " + std::to_string(o.maximumEdge) +
                         ", but must be a length, or 0 for no limit");
  }
  return std::nullopt;
}

std::vector<Vec3> CentresOf(const TriangleComplex& surface, const std::vector<Id>& triangles)
{
  std::vector<Vec3> centres;
  for (Id t : triangles)
  {
    Vec3 sum;
    for (Id p : surface.triangles[static_cast<std::size_t>(t)])
    {
      sum += surface.points[static_cast<std::size_t>(p)];
    }
    centres.push_back(sum * (1.0 / 3));
  }
  return centres;
}

std::optional<Error> CheckCoreSurface(const TriangleComplex& surface, const std::vector<Vec3>& interior,
                                      CoreTetsReport& report, Monitor& monitor)
{
  if (auto error = CheckClosed(surface, false, monitor))
  {
    return error;
  }
  if (!std::all_of(interior.begin(), interior.end(), IsFinite))
  {
    return InvalidInput("an interior point is not a finite position");
  }
  std::optional<Error> error =
    CheckEmbedded(surface.points, surface.triangles, "the surface", monitor, &report.offendingTriangles);
  if (error && error->kind == Failure::InvalidInput)
  {
    error->message += ": smooth it again with less drift, or thin the layers there";
  }
  return error;
}

} // namespace lamina
