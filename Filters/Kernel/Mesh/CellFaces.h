// SPDX-License-Identifier: BSD-3-Clause
// The faces of a mesh of mixed cells, each with the cells that have it.
#pragma once

#include "../Base/Monitor.h"
#include "VolumeMesh.h"

namespace lamina
{

/// One cell's face: its corners counter-clockwise seen from outside, the fourth -1 for a triangle.
struct CellFace
{
  std::array<Id, 4> corners{ { -1, -1, -1, -1 } };
  Id cell = -1;
  bool IsQuad() const { return this->corners[3] >= 0; }
};

/// All faces, those of the same corners side by side: group g is faces[start[g]] to faces[start[g + 1] - 1],
/// in the order of their cells. Groups are ordered by their sorted corners.
struct CellFaces
{
  std::vector<CellFace> faces;
  std::vector<std::size_t> start;

  std::size_t GroupCount() const { return this->start.empty() ? 0 : this->start.size() - 1; }
  /// The group of the triangle with these corners in any order, else -1.
  Id Find(const Triangle& corners) const;

  std::vector<std::size_t> startOfPoint; ///< first group whose lowest corner is point p; one more than points
};

CellFaces FindCellFaces(const VolumeMesh& mesh, Monitor& monitor);

/// Faces of a cell: 4 of a tetrahedron (each opposite to its node of the same number), 5 of a wedge (the two
/// triangles, then the quads) and of a pyramid (the base, then the triangles).
int FaceCount(CellType type);
/// Local nodes of face `local`, counter-clockwise seen from outside, the fourth -1 for a triangle.
const std::array<int, 4>& FaceNodes(CellType type, int local);
/// Face `local` of a cell.
CellFace FaceOf(const VolumeMesh& mesh, Id cell, int local);
/// The number of `face` among the faces of its cell.
int LocalFace(const VolumeMesh& mesh, const CellFace& face);

/// The edges of a cell of this type, as pairs of local nodes: around the base, around the roof, then upwards.
/// It is the order of middle nodes in VTK, Abaqus, FEBio and others. 6, 9 or 8.
const std::vector<std::array<int, 2>>& EdgeNodes(CellType type);

/// True if the faces, of the same corners, are one polygon seen from its two sides.
bool AreOpposite(const CellFace& a, const CellFace& b);

} // namespace lamina
