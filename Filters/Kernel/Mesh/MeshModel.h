// SPDX-License-Identifier: BSD-3-Clause
// A mesh as solvers' files hold it: named materials, side sets, node sets, layers; of no format.
#pragma once

#include "../Base/Result.h"
#include "MeshPatches.h"
#include "VolumeMesh.h"

namespace lamina
{

struct MeshModel
{
  VolumeMesh mesh; ///< corners; with quadratic cells its points hold the middle nodes too
  MeshPatches patches;
  std::vector<Id> twins;         ///< one a point: TwinNodeIds; empty where nodes are shared
  std::vector<Id> middleOffsets; ///< empty for linear cells, else as mesh.offsets
  std::vector<Id> middles;       ///< middle nodes of the cells, in the order of EdgeNodes
  std::vector<Vec3> fibers;      ///< one a cell, or empty
  std::string unit;              ///< of length; empty: not known
  bool IsQuadratic() const { return !this->middleOffsets.empty(); }
};

/// One side of a cell.
struct Side
{
  Id cell = -1;
  int face = -1;
};

/// Named faces. The faces of an interface lie on its first material; where nodes are doubled there is a
/// second set of the same faces on the other's nodes, called "<name>_twin".
struct SideSet
{
  std::string name;
  PatchKind kind = PatchKind::Wall;
  MaterialPair pair;
  std::vector<Side> sides;
};

/// Cells of one material and layer.
struct LayerSet
{
  std::string name; ///< layer_<material>_<n>
  std::vector<Id> cells;
};

/// The middle node of the edge between two local corners of a quadratic cell.
Id MiddleNode(const MeshModel& model, Id cell, int a, int b);

std::vector<SideSet> SideSetsOf(const MeshModel& model);
/// All nodes of the sides (middle ones too), ascending, each once.
std::vector<Id> NodesOf(const MeshModel& model, const SideSet& set);
/// Cells with LayerIds of 1 or more, by material and layer.
std::vector<LayerSet> LayerSetsOf(const MeshModel& model);
/// The materials that cells have, ascending.
std::vector<int> MaterialsOf(const MeshModel& model);

/// The cells of one material as a model of their own, with the patches of their boundary (interfaces turned
/// so that they lie on it). `nodes` gets for each node the id it had.
MeshModel TakeMaterial(const MeshModel& model, int material, std::vector<Id>& nodes);

} // namespace lamina
