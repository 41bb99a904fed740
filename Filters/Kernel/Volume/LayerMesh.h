// SPDX-License-Identifier: BSD-3-Clause
// Column cells as a volume mesh whose points are shared with other materials through the surface's point ids.
#pragma once

#include "ColumnCells.h"
#include "LayeredTets.h"

#include <optional>

namespace lamina
{

/// Collects the layers of several materials in one mesh: wall nodes are the surface's points, made once.
class LayerMesh
{
public:
  LayerMesh(const TriangleComplex& surface, VolumeMesh& mesh);

  /// Adds all layers of a wall and returns the mesh id of every front node.
  std::vector<Id> Add(const Wall& wall, const Columns& columns, ColumnCells kind, LayersReport& report);
  /// Tells the surface's triangles how many layers stand on them, and how high.
  static void Mark(const Wall& wall, const Columns& columns, LayersOnSurface& onSurface,
                   LayersReport& report);
  /// Tells the triangles round columns that lost the points (mesh ids, all added by the last Add() of this
  /// wall) how many layers are left, and counts the columns as thinned.
  void MarkLost(const Wall& wall, const Columns& columns, const std::vector<Id>& points,
                LayersOnSurface& onSurface, LayersReport& report) const;
  /// The mesh id of a point of the surface.
  Id WallPoint(Id surfacePoint);
  Id AddPoint(const Vec3& place, int layerIndex);

  /// How much of the mesh there is; what is added after it can be taken back.
  struct Bookmark
  {
    std::size_t points;
    std::size_t cells;
  };
  Bookmark Here() const { return { this->Mesh.points.size(), this->Mesh.types.size() }; }
  void BackTo(const Bookmark& mark);

private:
  const TriangleComplex& Surface;
  VolumeMesh& Mesh;
  std::vector<Id> PointOfSurface;
  Id FirstOfLayers = 0; ///< the first point of the last wall's layers
};

/// The front of columns as a closed surface that bounds the rest of the material: normals out of the core.
TriangleComplex FrontOf(const Wall& wall, const Columns& columns);

/// The materials asked for, each checked to occur in the surface.
Result<std::vector<int>> CheckMaterials(const TriangleComplex& surface, const std::vector<int>& asked,
                                        const char* what);

/// Arrays, closedness and thickness of a surface that layers are to grow on.
std::optional<Error> CheckLayerSurface(const TriangleComplex& surface, Monitor& monitor);

} // namespace lamina
