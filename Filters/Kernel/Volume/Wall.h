// SPDX-License-Identifier: BSD-3-Clause
// The boundary of one material, seen from inside: what layers grow on.
#pragma once

#include "../Mesh/Adjacency.h"

namespace lamina
{

/// A plane end of a material that borders on nothing meshed: columns on its rim stay in its plane, and what
/// is left of it inside them is triangulated anew (FrontCaps.h).
struct WallCap
{
  Vec3 origin;
  Vec3 normal;                        ///< unit, out of the material
  double extent = 0;                  ///< largest distance of its points from origin
  double edge = 0;                    ///< mean length of its edges
  std::vector<std::array<Id, 2>> rim; ///< points of the wall, the cap on the left as seen from outside
  std::vector<Id> surfaceTriangles;
};

/// Points and triangles of a material's boundary with ids of their own. Normals point into the material.
struct Wall
{
  int material = 0;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  std::vector<Id> surfacePoints;    ///< id in the surface, a point
  std::vector<Id> surfaceTriangles; ///< id in the surface, a triangle
  std::vector<double> thickness;    ///< of the material at each point; may be empty
  std::vector<char> fixed;          ///< points of openings and walls not chosen: no layers grow there
  std::vector<WallCap> caps;        ///< their triangles are not among those above
  std::vector<int> capOf;           ///< a point: the cap whose plane its column stays in, -1 for none
  Lists star;
};

/// Where layers grow.
struct WallChoice
{
  std::vector<int> neighbours; ///< towards those materials only, 0 the outside; empty: towards all
  std::vector<int> patches;    ///< on those patches only; empty: on all that are no openings
  bool hasCaps = false;        ///< openings become caps where they are plane; else their points are fixed
};

Wall MakeWall(const TriangleComplex& surface, int material, const WallChoice& choice = {});

} // namespace lamina
