// SPDX-License-Identifier: BSD-3-Clause
// What the prisms behind a front ask of the tets on it.
#pragma once

#include "../Mesh/TetFaces.h"
#include "../Mesh/TriangleComplex.h"

namespace lamina
{

/// The last prisms behind the triangles of a front, found by their corners, and how well a tet on one fits.
class FrontCells
{
public:
  /// The front's points must be the first ones of the tets. Without layerSide nothing is asked.
  explicit FrontCells(const TriangleComplex& front);

  /// What the fit over a face allows to a tet with this corner opposite to it; 1: nothing amiss, or no prism
  /// behind. Two measures on the scale of 3r/R: the cosine between the face's normal and the line of the
  /// cells' centres (non-orthogonality; 82 degrees count 0.2), and the tet's volume over the prism's (0.5 to
  /// 2 are 0.25 and more, 0.3 to 3 are 0.22 and more, but never less than 0.12: shape comes first).
  double FitOver(const Triangle& face, const std::vector<Vec3>& points, const Vec3& apex) const;
  /// The least over the tet's faces.
  double FitOf(const std::array<Id, 4>& tet, const std::vector<Vec3>& points) const;
  /// The centre of the prism behind a face; null: none.
  const Vec3* CentreBehind(const Triangle& face) const;

private:
  struct Prism
  {
    Vec3 centre;
    double volume = 0; ///< 0: none
  };
  bool IsOnFront(Id point) const { return point < this->PointCount; }
  const Prism* Behind(const Triangle& face) const;

  Id PointCount = 0;
  std::vector<Prism> Prisms;
  FaceTable Table;
};

} // namespace lamina
