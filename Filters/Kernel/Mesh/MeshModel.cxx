// SPDX-License-Identifier: BSD-3-Clause
#include "MeshModel.h"

#include "CellFaces.h"

#include <algorithm>
#include <set>

namespace lamina
{
namespace
{

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

/// Local nodes of the edges of a cell, in VTK's order, for the middle nodes of faces.
const std::vector<std::array<int, 2>>& Edges(CellType type)
{
  static const std::vector<std::array<int, 2>> tet{ { { 0, 1 } }, { { 1, 2 } }, { { 0, 2 } },
                                                    { { 0, 3 } }, { { 1, 3 } }, { { 2, 3 } } };
  static const std::vector<std::array<int, 2>> wedge{ { { 0, 1 } }, { { 1, 2 } }, { { 0, 2 } },
                                                      { { 3, 4 } }, { { 4, 5 } }, { { 3, 5 } },
                                                      { { 0, 3 } }, { { 1, 4 } }, { { 2, 5 } } };
  static const std::vector<std::array<int, 2>> pyramid{ { { 0, 1 } }, { { 1, 2 } }, { { 2, 3 } },
                                                        { { 0, 3 } }, { { 0, 4 } }, { { 1, 4 } },
                                                        { { 2, 4 } }, { { 3, 4 } } };
  return type == CellType::Tetrahedron ? tet : (type == CellType::Wedge ? wedge : pyramid);
}

bool IsDoubled(const MeshModel& model, const PatchFace& face)
{
  return face.otherCell >= 0 && !model.twins.empty() &&
         model.twins[Index(FaceOf(model.mesh, face.cell, face.face).corners[0])] >= 0;
}

} // namespace

Id MiddleNode(const MeshModel& model, Id cell, int a, int b)
{
  const auto& edges = Edges(model.mesh.types[Index(cell)]);
  const std::array<int, 2> ends{ { std::min(a, b), std::max(a, b) } };
  const auto at = std::find(edges.begin(), edges.end(), ends) - edges.begin();
  return model.middles[Index(model.middleOffsets[Index(cell)] + at)];
}

std::vector<SideSet> SideSetsOf(const MeshModel& model)
{
  std::vector<SideSet> sets;
  for (const MeshPatch& patch : model.patches.patches)
  {
    sets.push_back({ patch.name, patch.kind, patch.pair, {} });
  }
  std::vector<SideSet> twins(sets.size());
  for (const PatchFace& face : model.patches.faces)
  {
    SideSet& own = sets[Index(face.patch)];
    own.sides.push_back({ face.cell, face.face });
    if (IsDoubled(model, face))
    {
      SideSet& twin = twins[Index(face.patch)];
      twin.name = own.name + "_twin";
      twin.kind = own.kind;
      twin.pair = { own.pair.second, own.pair.first };
      twin.sides.push_back({ face.otherCell, face.otherFace });
    }
  }
  for (SideSet& twin : twins)
  {
    if (!twin.sides.empty())
    {
      sets.push_back(std::move(twin));
    }
  }
  return sets;
}

std::vector<Id> NodesOf(const MeshModel& model, const SideSet& set)
{
  std::vector<Id> nodes;
  for (const Side& side : set.sides)
  {
    const auto& local = FaceNodes(model.mesh.types[Index(side.cell)], side.face);
    const std::size_t n = local[3] < 0 ? 3 : 4;
    for (std::size_t k = 0; k < n; ++k)
    {
      nodes.push_back(model.mesh.Cell(side.cell)[local[k]]);
      if (model.IsQuadratic())
      {
        nodes.push_back(MiddleNode(model, side.cell, local[k], local[(k + 1) % n]));
      }
    }
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

std::vector<LayerSet> LayerSetsOf(const MeshModel& model)
{
  std::map<std::pair<int, int>, std::vector<Id>> cells;
  for (std::size_t c = 0; c < model.mesh.layers.size(); ++c)
  {
    if (model.mesh.layers[c] > 0)
    {
      cells[{ model.mesh.materials[c], model.mesh.layers[c] }].push_back(static_cast<Id>(c));
    }
  }
  std::vector<LayerSet> sets;
  for (auto& [key, list] : cells)
  {
    const auto found = model.patches.materialNames.find(key.first);
    const std::string material =
      found == model.patches.materialNames.end() ? std::to_string(key.first) : found->second;
    sets.push_back({ "layer_" + material + "_" + std::to_string(key.second), std::move(list) });
  }
  return sets;
}

std::vector<int> MaterialsOf(const MeshModel& model)
{
  const std::set<int> all(model.mesh.materials.begin(), model.mesh.materials.end());
  return { all.begin(), all.end() };
}

MeshModel TakeMaterial(const MeshModel& model, int material, std::vector<Id>& nodes)
{
  const VolumeMesh& mesh = model.mesh;
  MeshModel part;
  part.unit = model.unit;
  part.patches.materialNames = model.patches.materialNames;
  std::vector<Id> nodeOf(mesh.points.size(), -1);
  std::vector<Id> cellOf(mesh.types.size(), -1);
  nodes.clear();
  const auto take = [&](Id node)
  {
    if (nodeOf[Index(node)] < 0)
    {
      nodeOf[Index(node)] = static_cast<Id>(nodes.size());
      nodes.push_back(node);
      part.mesh.points.push_back(mesh.points[Index(node)]);
    }
    return nodeOf[Index(node)];
  };
  const auto cells =
    static_cast<std::size_t>(std::count(mesh.materials.begin(), mesh.materials.end(), material));
  part.mesh.types.reserve(cells);
  part.mesh.offsets.reserve(cells + 1);
  part.mesh.connectivity.reserve(cells * mesh.connectivity.size() /
                                 std::max<std::size_t>(1, mesh.types.size()));
  for (std::size_t c = 0; c < mesh.types.size(); ++c)
  {
    if (mesh.materials[c] != material)
    {
      continue;
    }
    cellOf[c] = part.mesh.CellCount();
    for (Id i = mesh.offsets[c]; i < mesh.offsets[c + 1]; ++i)
    {
      part.mesh.connectivity.push_back(take(mesh.connectivity[Index(i)]));
    }
    part.mesh.types.push_back(mesh.types[c]);
    part.mesh.offsets.push_back(static_cast<Id>(part.mesh.connectivity.size()));
    part.mesh.materials.push_back(material);
    part.mesh.layers.push_back(mesh.layers.empty() ? 0 : mesh.layers[c]);
    if (!model.fibers.empty())
    {
      part.fibers.push_back(model.fibers[c]);
    }
  }
  // Patches of this material's boundary, in their order.
  std::vector<int> patchOf(model.patches.patches.size(), -1);
  for (const PatchFace& face : model.patches.faces)
  {
    const MeshPatch& patch = model.patches.patches[Index(face.patch)];
    const bool isFirst = patch.pair.first == material;
    if (!isFirst && patch.pair.second != material)
    {
      continue;
    }
    int& number = patchOf[Index(face.patch)];
    if (number < 0)
    {
      number = static_cast<int>(part.patches.patches.size());
      part.patches.patches.push_back(patch);
      part.patches.patches.back().pair = { material, isFirst ? patch.pair.second : patch.pair.first };
      part.patches.patches.back().faces = 0;
    }
    ++part.patches.patches[Index(number)].faces;
    part.patches.faces.push_back({ cellOf[Index(isFirst ? face.cell : face.otherCell)],
                                   isFirst ? face.face : face.otherFace, number, -1, -1 });
  }
  return part;
}

} // namespace lamina
