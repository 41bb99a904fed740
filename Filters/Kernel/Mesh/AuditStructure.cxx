// SPDX-License-Identifier: BSD-3-Clause
#include "AuditStructure.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace lamina
{
namespace
{

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

} // namespace

void CountComponents(const VolumeMesh& mesh, const CellFaces& faces, AuditReport& report)
{
  const auto materialOf = [&](const CellFace& face) { return mesh.materials[Index(face.cell)]; };
  std::vector<Id> parent(Index(mesh.CellCount()));
  std::iota(parent.begin(), parent.end(), Id{ 0 });
  const auto root = [&](Id c)
  {
    while (parent[Index(c)] != c)
    {
      c = parent[Index(c)] = parent[Index(parent[Index(c)])];
    }
    return c;
  };
  for (std::size_t g = 0; g < faces.GroupCount(); ++g)
  {
    const CellFace* face = faces.faces.data() + faces.start[g];
    for (std::size_t i = 1; i < (faces.start[g + 1] - faces.start[g]); ++i)
    {
      if (materialOf(face[0]) == materialOf(face[i]))
      {
        const Id a = root(face[0].cell);
        const Id b = root(face[i].cell);
        parent[Index(std::max(a, b))] = std::min(a, b);
      }
    }
  }
  std::map<int, Id> components;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    components[mesh.materials[Index(c)]] += parent[Index(c)] == c;
  }
  for (MaterialAudit& material : report.materials)
  {
    material.components = components[material.material];
  }
}

void CountStacks(const VolumeMesh& mesh, const CellFaces& faces, AuditReport& report)
{
  const auto materialOf = [&](const CellFace& face) { return mesh.materials[Index(face.cell)]; };
  // The cells on both sides of each wedge's two triangles.
  std::map<int, Id>& heights = report.stackHeights;
  std::vector<Id> above(mesh.types.size(), -1); // the wedge at the second triangle of a wedge
  std::vector<char> isFoot(mesh.types.size(), 0);
  const auto isWedge = [&](const CellFace& face)
  { return mesh.types[Index(face.cell)] == CellType::Wedge && !face.IsQuad(); };
  const auto local = [&](const CellFace& face) { return LocalFace(mesh, face); };
  for (std::size_t g = 0; g < faces.GroupCount(); ++g)
  {
    const CellFace* face = faces.faces.data() + faces.start[g];
    const std::size_t size = (faces.start[g + 1] - faces.start[g]);
    for (std::size_t i = 0; i < std::min<std::size_t>(size, 2); ++i)
    {
      const CellFace* other = size == 2 ? face + (1 - i) : nullptr;
      if (!isWedge(face[i]))
      {
        continue;
      }
      const bool isSame = other != nullptr && isWedge(*other) && materialOf(*other) == materialOf(face[i]);
      if (local(face[i]) == 0)
      {
        isFoot[Index(face[i].cell)] = !isSame;
      }
      else if (isSame && local(*other) == 0)
      {
        above[Index(face[i].cell)] = other->cell;
      }
    }
  }
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    int height = 0;
    for (Id at = isFoot[Index(c)] != 0 ? c : -1; at >= 0; at = above[Index(at)])
    {
      ++height;
    }
    if (height > 0)
    {
      ++heights[height];
    }
  }
}

} // namespace lamina
