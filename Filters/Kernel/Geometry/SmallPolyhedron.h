// SPDX-License-Identifier: BSD-3-Clause
// The best tetrahedra in a polyhedron of a few corners.
#pragma once

#include "../Base/Types.h"

#include <functional>
#include <vector>

namespace lamina
{

struct SmallPolyhedron
{
  std::vector<Vec3> points;              ///< at most MostPoints; corners, and points inside
  std::vector<std::array<int, 3>> faces; ///< closed, counter-clockwise seen from outside
  std::vector<char> mayGo;               ///< one a point: not 0 if no tet need use it
  std::function<bool(int, int)> allows;  ///< whether an edge that is not there yet may be made; empty: any
  static constexpr std::size_t MostPoints = 24;
};

/// Searches for positive tets, in VTK's order, that fill the polyhedron, keep its faces, make no other points
/// and whose least score of four of its points is as high as possible and above `floor`, which is raised to
/// it; none if nothing was found in so many steps. Faces are filled one after the other, the one with the
/// fewest choices first, and what cannot beat the best so far is cut off. Closed faces and positive tets
/// prove that nothing overlaps. After J. Liu, S. Sun, D. Wang: Optimal tetrahedralization for small
/// polyhedron, Computer Modeling in Engineering and Sciences 14 (2006), and C. Marot, K. Verhetsel, J.-F.
/// Remacle: Reviving the search for optimal tetrahedralizations, 28th International Meshing Roundtable
/// (2020).
std::vector<std::array<int, 4>> FillPolyhedron(const SmallPolyhedron& polyhedron,
                                               const std::function<double(const std::array<int, 4>&)>& score,
                                               double& floor, int steps);

} // namespace lamina
