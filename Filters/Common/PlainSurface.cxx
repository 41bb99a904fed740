// SPDX-License-Identifier: BSD-3-Clause
#include "PlainSurface.h"

#include "MeshArrayNames.h"

#include "Mesh/Closedness.h"
#include "Mesh/VolumeCorrection.h"

#include <algorithm>

namespace lamina
{

Status LabelPlainSurface(TriangleComplex& surface, Monitor& monitor)
{
  surface.materials.assign(surface.triangles.size(), MaterialPair{ 1, 0 });
  if (const auto unsound = CheckArrays(surface))
  {
    return *unsound;
  }
  constexpr bool manifold = true;
  if (const auto open = CheckClosed(surface, manifold, monitor))
  {
    return InvalidInput(
      std::string("no ") + names::BoundaryLabels +
        " on the triangles: run Multimaterial Marching Cubes first. A surface without them must be closed "
        "and of one orientation (points that coincide count as different: run Clean), but " +
        open->message,
      open->places);
  }
  if (MaterialVolumes(surface, { 1 }).front() < 0)
  {
    for (Triangle& t : surface.triangles)
    {
      std::swap(t[1], t[2]);
    }
  }
  return Done{};
}

} // namespace lamina
