// SPDX-License-Identifier: BSD-3-Clause
#include "ImproveLayers.h"

#include "ImproveStuck.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

namespace lamina
{

namespace
{

using Tet = std::array<Id, 4>;

constexpr double ModestTarget = 0.21; ///< a little more than an angle of 8 degrees counts as
constexpr double StuckGate = 0.12;    ///< tets of a lower shape may cost layers
constexpr double StuckTarget = 0.14;

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

/// The cells from firstCell on; `global` gets the mesh's id of every point of the set.
TetSet Gather(const VolumeMesh& mesh, std::size_t firstCell, std::vector<Id>& global)
{
  TetSet set;
  std::vector<Id> local(mesh.points.size(), -1);
  for (std::size_t c = firstCell; c < mesh.types.size(); ++c)
  {
    Tet tet;
    for (std::size_t i = 0; i < 4; ++i)
    {
      const Id p = mesh.Cell(static_cast<Id>(c))[i];
      if (local[U(p)] < 0)
      {
        local[U(p)] = static_cast<Id>(global.size());
        global.push_back(p);
        set.points.push_back(mesh.points[U(p)]);
        set.fixed.push_back(mesh.layerIndex[U(p)] == 0 ? 1 : 0);
        set.layerIndex.push_back(mesh.layerIndex[U(p)]);
      }
      tet[i] = local[U(p)];
    }
    set.tets.push_back(tet);
  }
  return set;
}

/// Ends of the tet's first edge, by ids, between layers that differ by more than one; false if it has none.
bool FindWideEdge(const TetSet& set, const Tet& tet, std::pair<Id, Id>& edge)
{
  bool found = false;
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t j = i + 1; j < 4; ++j)
    {
      const int a = set.layerIndex[U(tet[i])];
      const int b = set.layerIndex[U(tet[j])];
      const std::pair<Id, Id> ends = std::minmax(tet[i], tet[j]);
      if (a >= 0 && b >= 0 && std::abs(a - b) > 1 && (!found || ends < edge))
      {
        edge = ends;
        found = true;
      }
    }
  }
  return found;
}

/// The core may join layers that differ by more than one, where columns lack some: such edges get a point of
/// no layer in the middle. Tets take them in one order, so that their faces still fit.
void SplitWideEdges(TetSet& set)
{
  std::map<std::pair<Id, Id>, Id> middles;
  std::pair<Id, Id> edge;
  for (std::size_t t = 0; t < set.tets.size(); ++t)
  {
    while (FindWideEdge(set, set.tets[t], edge))
    {
      const auto [entry, isNew] = middles.insert({ edge, static_cast<Id>(set.points.size()) });
      if (isNew)
      {
        set.points.push_back(0.5 * (set.points[U(edge.first)] + set.points[U(edge.second)]));
        set.fixed.push_back(0);
        set.layerIndex.push_back(-1);
      }
      Tet other = set.tets[t];
      std::replace(set.tets[t].begin(), set.tets[t].end(), edge.first, entry->second);
      std::replace(other.begin(), other.end(), edge.second, entry->second);
      set.tets.push_back(other);
    }
  }
}

/// Takes points that no tet has any more out of the mesh.
void DropUnused(const TetSet& set, VolumeMesh& mesh, std::vector<Id>& global)
{
  std::vector<char> isUsed(set.points.size(), 0);
  for (const Tet& tet : set.tets)
  {
    for (Id p : tet)
    {
      isUsed[U(p)] = 1;
    }
  }
  std::vector<char> isDropped(mesh.points.size(), 0);
  for (std::size_t p = 0; p < global.size(); ++p)
  {
    isDropped[U(global[p])] = isUsed[p] == 0 ? 1 : 0;
  }
  std::vector<Id> renumber(mesh.points.size());
  std::size_t to = 0;
  for (std::size_t from = 0; from < mesh.points.size(); ++from)
  {
    renumber[from] = static_cast<Id>(to);
    if (isDropped[from] == 0)
    {
      mesh.points[to] = mesh.points[from];
      mesh.layerIndex[to] = mesh.layerIndex[from];
      mesh.interfaceNodeIds[to] = mesh.interfaceNodeIds[from];
      ++to;
    }
  }
  mesh.points.resize(to);
  mesh.layerIndex.resize(to);
  mesh.interfaceNodeIds.resize(to);
  std::transform(global.begin(), global.end(), global.begin(), [&](Id p) { return renumber[U(p)]; });
}

/// The layer of a tet follows from its nodes: between layers k - 1 and k it is k, with a free node it is
/// core.
int LayerOf(const TetSet& set, const Tet& tet, int columnLayers)
{
  int highest = 0;
  bool isCore = false;
  for (Id p : tet)
  {
    highest = std::max(highest, set.layerIndex[U(p)]);
    isCore = isCore || set.layerIndex[U(p)] < 0;
  }
  const bool isFlat =
    std::all_of(tet.begin(), tet.end(), [&](Id p) { return set.layerIndex[U(p)] == highest; });
  return isCore || (isFlat && highest == columnLayers) ? 0 : std::max(1, highest);
}

/// What is still poor is worked on by force, at the cost of layers at last.
void WorkOnStuck(TetSet& set, ImproveTetsReport& report, Monitor& monitor)
{
  const std::vector<int> before = set.layerIndex;
  ImproveStuckOptions options;
  options.gate = StuckGate;
  options.target = StuckTarget;
  options.rings = { 2, 3 };
  options.rounds = 12;
  ImproveStuck(set, options, monitor);
  for (std::size_t p = 0; p < before.size(); ++p)
  {
    if (before[p] >= 0 && set.layerIndex[p] < 0)
    {
      report.takenFromLayers.push_back(static_cast<Id>(p));
    }
  }
}

} // namespace

ImproveTetsReport ImproveLayers(VolumeMesh& mesh, std::size_t firstCell, int columnLayers, Monitor& monitor)
{
  std::vector<Id> global;
  TetSet set = Gather(mesh, firstCell, global);
  SplitWideEdges(set);
  ImproveTetsOptions options;
  options.modestTarget = ModestTarget;
  ImproveTetsReport report = ImproveTets(set, options, monitor);
  WorkOnStuck(set, report, monitor);
  for (std::size_t p = 0; p < set.points.size(); ++p)
  {
    if (p < global.size())
    {
      mesh.points[U(global[p])] = set.points[p];
      mesh.layerIndex[U(global[p])] = set.layerIndex[p];
      continue;
    }
    global.push_back(static_cast<Id>(mesh.points.size()));
    mesh.points.push_back(set.points[p]);
    mesh.layerIndex.push_back(-1);
    mesh.interfaceNodeIds.push_back(-1);
  }
  for (Id& p : report.takenFromLayers)
  {
    p = global[U(p)];
  }
  DropUnused(set, mesh, global);
  const int material = firstCell < mesh.materials.size() ? mesh.materials[firstCell] : 0;
  mesh.types.resize(firstCell);
  mesh.offsets.resize(firstCell + 1);
  mesh.connectivity.resize(U(mesh.offsets.back()));
  mesh.materials.resize(firstCell);
  mesh.layers.resize(firstCell);
  for (const Tet& tet : set.tets)
  {
    mesh.AddCell<4>(CellType::Tetrahedron,
                    { global[U(tet[0])], global[U(tet[1])], global[U(tet[2])], global[U(tet[3])] }, material,
                    LayerOf(set, tet, columnLayers));
  }
  return report;
}

} // namespace lamina
