// SPDX-License-Identifier: BSD-3-Clause
// Volume cells with their points: tetrahedra, wedges and pyramids in VTK's node order.
#pragma once

#include "../Base/Types.h"

#include <vector>

namespace lamina
{

/// Cell types, with VTK's numbers and node orders. VTK's wedge has its first triangle's normal pointing *out*
/// of the cell (away from nodes 3, 4, 5); tets and pyramids have their base normal pointing to the apex.
enum class CellType : unsigned char
{
  Tetrahedron = 10,
  Wedge = 13,
  Pyramid = 14
};
inline int NodeCount(CellType type)
{
  return type == CellType::Tetrahedron ? 4 : (type == CellType::Wedge ? 6 : 5);
}

/// A mesh of mixed cells in the layout of vtkCellArray: cell c's nodes are
/// connectivity[offsets[c]] to connectivity[offsets[c + 1] - 1].
struct VolumeMesh
{
  std::vector<Vec3> points;
  std::vector<CellType> types;
  std::vector<Id> offsets{ 0 };
  std::vector<Id> connectivity;

  std::vector<int> materials;       ///< one a cell: MaterialIds
  std::vector<int> layers;          ///< one a cell: LayerIds, 1 touches the wall, 0 core
  std::vector<int> layerIndex;      ///< one a point: LayerIndex, 0 on a wall, -1 in a core
  std::vector<Id> interfaceNodeIds; ///< one a point: the surface point it is, else -1

  Id CellCount() const { return static_cast<Id>(this->types.size()); }
  const Id* Cell(Id c) const
  {
    return this->connectivity.data() + this->offsets[static_cast<std::size_t>(c)];
  }
  template<std::size_t N>
  void AddCell(CellType type, const std::array<Id, N>& nodes, int material, int layer)
  {
    this->types.push_back(type);
    this->connectivity.insert(this->connectivity.end(), nodes.begin(), nodes.end());
    this->offsets.push_back(static_cast<Id>(this->connectivity.size()));
    this->materials.push_back(material);
    this->layers.push_back(layer);
  }
};

/// Where the N nodes of a cell lie.
template<std::size_t N>
std::array<Vec3, N> PlacesOf(const VolumeMesh& mesh, Id cell)
{
  std::array<Vec3, N> places;
  for (std::size_t k = 0; k < N; ++k)
  {
    places[k] = mesh.points[static_cast<std::size_t>(mesh.Cell(cell)[k])];
  }
  return places;
}

} // namespace lamina
