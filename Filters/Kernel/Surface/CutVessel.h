// SPDX-License-Identifier: BSD-3-Clause
// A vessel cut off by a plane that a user places.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/TriangleComplex.h"

namespace lamina
{

struct CutVesselOptions
{
  Vec3 origin;                         ///< in the plane, inside the vessel or beside it
  Vec3 normal{ 0, 0, 1 };              ///< towards what is cut off; of any length but 0
  std::vector<int> openMaterials{ 2 }; ///< whose ends are openings; those of others are borders
  std::string name;                    ///< of the patches: opening_<name>, border_<name>; empty: a number
};

struct CutVesselReport
{
  Id sections = 0;     ///< pieces of the plane that were cut: more than 1 where what is cut off comes back
  double area = 0;     ///< of these pieces
  double cutShare = 0; ///< of the volume of all materials, 0 to 1
  Id cutTriangles = 0; ///< taken away
  Id endTriangles = 0; ///< in the plane ends
  std::vector<std::string> patches; ///< names of the new ones
};

/// Take away what lies beyond a plane, as far as it hangs together with the piece of material that the plane
/// cuts at `origin` (or, if none is there, with the nearest piece, if it is nearer than half the root of its
/// area); other bodies that the plane meets stay as they are. Plane ends close the surface: a patch a
/// connected end of an open material, one patch for the ends of all others. Points within a quarter of an
/// edge of the plane are moved into it, if that leaves the surface sound. The result is closed, and no two
/// triangles intersect, if that held before. A failure if the plane misses.
///
/// Only points, triangles, materials, patches and junctions are kept: sizes have to be found anew.
Result<CutVesselReport> CutVessel(TriangleComplex& surface, const CutVesselOptions& options,
                                  Monitor& monitor);

} // namespace lamina
