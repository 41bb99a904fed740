// SPDX-License-Identifier: BSD-3-Clause
// Triangles that fill plane regions with holes.
#pragma once

#include "../Base/Types.h"

namespace lamina
{

/// Two coordinates in a plane.
struct Vec2
{
  double x = 0;
  double y = 0;
};

/// Edges of plane regions, each with the region on its left, as pairs of ids into a list of places.
using PlaneEdges = std::vector<std::array<Id, 2>>;

/// A region of the plane: its rim and the rims of its holes, as rings of ids. The region lies on the left.
struct FlatRegion
{
  std::vector<Id> rim;
  std::vector<std::vector<Id>> holes;
};

/// The regions that edges enclose. Where several edges leave a place, regions that only touch there stay
/// apart. Empty if the edges do not close, or if one runs both ways.
std::vector<FlatRegion> FindFlatRegions(const std::vector<Vec2>& places, const PlaneEdges& edges);

/// Fill a region with triangles, counter-clockwise: a Delaunay triangulation that keeps the rims, with places
/// added inside at about `spacing` from each other (none if it is 0). New places are appended to `places`.
/// Ears are cut with exact signs (G. H. Meisters, Polygons have ears, 1975; holes are joined to the rim by
/// bridges), then edges are flipped (C. L. Lawson, 1977). Empty if the rims are not simple.
std::vector<Triangle> FillFlatRegion(std::vector<Vec2>& places, const FlatRegion& region, double spacing);

/// The area inside a ring, positive if it runs counter-clockwise.
double AreaOf(const std::vector<Vec2>& places, const std::vector<Id>& ring);

} // namespace lamina
