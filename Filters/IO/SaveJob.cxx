// SPDX-License-Identifier: BSD-3-Clause
#include "SaveJob.h"

namespace lamina
{

bool SaveJob::Keep(const Status& one)
{
  if (this->status && !one)
  {
    this->status = one;
  }
  return static_cast<bool>(this->status);
}

bool SaveJob::GoesOn(double fraction, const char* what)
{
  this->monitor.Progress(fraction, what);
  if (this->status && this->monitor.Cancelled())
  {
    this->status = Cancelled();
  }
  return static_cast<bool>(this->status);
}

std::string TitleOf(const MeshModel& model)
{
  return "Fluid-solid mesh by Lamina" + (model.unit.empty() ? "" : ", lengths in " + model.unit);
}

std::vector<Id> CellsOf(const MeshModel& model, int material, CellType type)
{
  std::vector<Id> cells;
  for (std::size_t c = 0; c < model.mesh.types.size(); ++c)
  {
    if (model.mesh.materials[c] == material && model.mesh.types[c] == type)
    {
      cells.push_back(static_cast<Id>(c));
    }
  }
  return cells;
}

int OrderedNodes(const MeshModel& model, Id cell, const std::vector<std::array<int, 2>>& edges,
                 std::array<Id, 15>& nodes)
{
  constexpr int turned[6] = { 0, 2, 1, 3, 5, 4 };
  const CellType type = model.mesh.types[static_cast<std::size_t>(cell)];
  const Id* own = model.mesh.Cell(cell);
  const int corners = NodeCount(type);
  const auto local = [&](int k) { return type == CellType::Wedge ? turned[k] : k; };
  for (int k = 0; k < corners; ++k)
  {
    nodes[static_cast<std::size_t>(k)] = own[local(k)];
  }
  if (!model.IsQuadratic())
  {
    return corners;
  }
  int count = corners;
  for (const auto& edge : edges)
  {
    nodes[static_cast<std::size_t>(count++)] = MiddleNode(model, cell, local(edge[0]), local(edge[1]));
  }
  return count;
}

int SideNodes(const MeshModel& model, const Side& side, std::array<Id, 8>& nodes)
{
  const auto& local = FaceNodes(model.mesh.types[static_cast<std::size_t>(side.cell)], side.face);
  const int n = local[3] < 0 ? 3 : 4;
  for (int k = 0; k < n; ++k)
  {
    const auto at = static_cast<std::size_t>(k);
    nodes[at] = model.mesh.Cell(side.cell)[local[at]];
    if (model.IsQuadratic())
    {
      nodes[static_cast<std::size_t>(n + k)] =
        MiddleNode(model, side.cell, local[at], local[static_cast<std::size_t>((k + 1) % n)]);
    }
  }
  return model.IsQuadratic() ? 2 * n : n;
}

} // namespace lamina
