// SPDX-License-Identifier: BSD-3-Clause
// What a format's Save gets: the model with its names fitted to the format.
#pragma once

#include "Stage.h"
#include "TextFile.h"

#include "Base/Monitor.h"
#include "Mesh/CellFaces.h"
#include "Mesh/FormatLimits.h"
#include "Mesh/MeshModel.h"

#include <map>

class vtkUnstructuredGrid;

namespace lamina
{

struct SaveJob
{
  std::string path;
  const MeshModel& model;
  vtkUnstructuredGrid* grid; ///< the input, for writers of VTK
  Monitor& monitor;
  std::vector<SideSet> sides;      ///< with fitted names
  std::vector<LayerSet> layers;    ///< with fitted names
  std::vector<int> materials;      ///< ascending
  std::map<int, std::string> name; ///< of each material, fitted
  std::vector<std::string> notes;  ///< warnings
  Status status = Done{};

  /// Keep the first failure; true if all is well so far and nobody wants to stop.
  bool Keep(const Status& one);
  /// Tell progress; false if the work is to end.
  bool GoesOn(double fraction, const char* what);
};

/// What a file is, with the unit of length if it is known: for its head.
std::string TitleOf(const MeshModel& model);
/// Cells of one material and type, ascending.
std::vector<Id> CellsOf(const MeshModel& model, int material, CellType type);
/// All types, in the order in which blocks are written.
constexpr CellType AllTypes[] = { CellType::Tetrahedron, CellType::Wedge, CellType::Pyramid };
/// Nodes of a cell in the order that all formats but VTK's use: the first triangle of a wedge looks towards
/// the second. Middle nodes are those between the pairs of `edges` (local numbers in that order).
int OrderedNodes(const MeshModel& model, Id cell, const std::vector<std::array<int, 2>>& edges,
                 std::array<Id, 15>& nodes);
/// The corners of a side, counter-clockwise seen from outside, then its middle nodes if there are any.
int SideNodes(const MeshModel& model, const Side& side, std::array<Id, 8>& nodes);

} // namespace lamina
