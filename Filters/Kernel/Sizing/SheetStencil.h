// SPDX-License-Identifier: BSD-3-Clause
// The part of one sheet around a point, gathered triangle by triangle.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/Adjacency.h"

namespace lamina
{

/// For each triangle, the triangle of the same sheet across its edge from corner k to corner k + 1; -1 where
/// the sheet ends.
using SheetNeighbours = std::vector<std::array<Id, 3>>;
SheetNeighbours FindSheetNeighbours(const TriangleComplex& surface, const Lists& star, Monitor& monitor);

/// The triangles of a sheet near a point and their corners, in an order that depends on the order of the
/// triangles alone. Meant to be used again and again by one thread.
class SheetStencil
{
public:
  SheetStencil(const TriangleComplex& surface, const SheetNeighbours& neighbours);

  /// Walk from triangle `seed` over all edges that have an end within `radius` of `centre`.
  void Gather(const Vec3& centre, Id seed, double radius);
  bool Has(Id triangle) const { return this->Triangles.Find(triangle) >= 0; }

  std::size_t Count() const { return this->Corners.ids.size(); }
  const Vec3& Point(std::size_t i) const
  {
    return this->Surface.points[static_cast<std::size_t>(this->Corners.ids[i])];
  }
  /// The sum of the gathered triangles' area vectors at corner i.
  const Vec3& Normal(std::size_t i) const { return this->Normals[i]; }

private:
  /// Ids in the order of their coming, found by hashing.
  struct Numbering
  {
    Numbering();
    Id Find(Id id) const; ///< -1 if not there
    Id Add(Id id);        ///< its number; a new one if it was not there
    void Clear();
    std::size_t Slot(Id id) const;

    std::vector<Id> ids;
    std::vector<Id> table;
  };

  const TriangleComplex& Surface;
  const SheetNeighbours& Neighbours;
  Numbering Triangles;
  Numbering Corners;
  std::vector<Vec3> Normals;
};

} // namespace lamina
