// SPDX-License-Identifier: BSD-3-Clause
// The boundary of one material, seen from inside: what layers grow on.
#pragma once

#include "../Mesh/Adjacency.h"

namespace lamina
{

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
  Lists star;
};

/// With `neighbours` layers grow only towards those materials (0 is the outside); empty: towards all.
Wall MakeWall(const TriangleComplex& surface, int material, const std::vector<int>& neighbours = {});

} // namespace lamina
