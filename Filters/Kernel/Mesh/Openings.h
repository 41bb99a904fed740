// SPDX-License-Identifier: BSD-3-Clause
// Boundary faces in the planes of a surface's openings, which border on nothing meshed and may be
// triangulated anew.
#pragma once

#include "CellFaces.h"
#include "TriangleComplex.h"

#include <string>

namespace lamina
{

/// The openings of a surface (may be null), each a plane patch; collects the faces of a mesh that lie in
/// them.
class Openings
{
public:
  Openings(const TriangleComplex* surface, double scale);
  /// True if the face lies in an opening's plane, within its box and facing as it does; its area is added
  /// there. With a patch other than 0 only that opening is asked.
  bool Add(const VolumeMesh& mesh, const CellFace& face, int patch);
  /// The patch of the opening that the face lies in as Add asks it, 0 if it lies in none.
  int Find(const VolumeMesh& mesh, const CellFace& face, int patch) const;
  /// A finding for each opening whose faces do not add up to its area.
  void Tell(std::vector<std::string>& findings) const;

private:
  struct Opening
  {
    int patch = 0;
    int material = 0; ///< on the meshed side
    Vec3 area;        ///< vector area, out of the material
    Vec3 covered;     ///< by faces of the mesh
    Vec3 origin;
    Vec3 low;
    Vec3 high;
    double extent = 0;
  };
  /// The opening the face lies in, -1 for none, and the face's vector area.
  int Locate(const VolumeMesh& mesh, const CellFace& face, int patch, Vec3& area) const;

  std::vector<Opening> All;
};

} // namespace lamina
