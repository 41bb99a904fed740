// SPDX-License-Identifier: BSD-3-Clause
#include "PolyMesh.h"

#include <algorithm>
#include <tuple>

namespace lamina
{
namespace
{

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

struct Inner
{
  Id owner;
  Id neighbour;
  CellFace face; ///< as the owner has it
};

std::array<Id, 4> KeyOf(const CellFace& face)
{
  auto key = face.corners;
  std::sort(key.begin(), key.end());
  return key;
}

void Add(const CellFace& face, PolyMesh& mesh)
{
  mesh.faces.insert(mesh.faces.end(), face.corners.begin(), face.corners.end());
  mesh.owners.push_back(face.cell);
}

/// Every inner face, sorted; the number of outer faces in `outer`.
Result<std::vector<Inner>> FindInner(const SaveJob& job, Id& outer)
{
  const CellFaces all = FindCellFaces(job.model.mesh, job.monitor);
  std::vector<Inner> inner;
  outer = 0;
  for (std::size_t g = 0; g < all.GroupCount(); ++g)
  {
    const std::size_t size = all.start[g + 1] - all.start[g];
    const CellFace* face = all.faces.data() + all.start[g];
    if (size > 2)
    {
      return InvalidInput("a face belongs to more than two cells: run Mesh Audit",
                          { job.model.mesh.points[Index(face->corners[0])] });
    }
    outer += size == 1;
    if (size == 2)
    {
      const bool isSwapped = face[1].cell < face[0].cell;
      inner.push_back(
        { face[isSwapped ? 1 : 0].cell, face[isSwapped ? 0 : 1].cell, face[isSwapped ? 1 : 0] });
    }
  }
  std::sort(inner.begin(), inner.end(),
            [](const Inner& a, const Inner& b)
            { return std::tie(a.owner, a.neighbour) < std::tie(b.owner, b.neighbour); });
  return inner;
}

} // namespace

Result<PolyMesh> MakePolyMesh(const SaveJob& job)
{
  Id outer = 0;
  const auto inner = FindInner(job, outer);
  if (!inner)
  {
    return inner.GetError();
  }
  PolyMesh mesh;
  std::vector<std::pair<std::array<Id, 4>, Id>> numbers; // of inner faces between materials
  for (const Inner& face : *inner)
  {
    if (job.model.mesh.materials[Index(face.owner)] != job.model.mesh.materials[Index(face.neighbour)])
    {
      numbers.emplace_back(KeyOf(face.face), static_cast<Id>(mesh.owners.size()));
    }
    Add(face.face, mesh);
    mesh.neighbours.push_back(face.neighbour);
  }
  std::sort(numbers.begin(), numbers.end());
  mesh.zoneFaces.resize(job.sides.size());
  mesh.zoneFlips.resize(job.sides.size());
  for (std::size_t s = 0; s < job.sides.size(); ++s)
  {
    mesh.patchStart.push_back(static_cast<Id>(mesh.owners.size()));
    for (const Side& side : job.sides[s].sides)
    {
      const CellFace face = FaceOf(job.model.mesh, side.cell, side.face);
      const auto key = KeyOf(face);
      const auto found = std::lower_bound(numbers.begin(), numbers.end(), std::make_pair(key, Id{ -1 }));
      if (found != numbers.end() && found->first == key)
      {
        mesh.zoneFaces[s].push_back(found->second);
        mesh.zoneFlips[s].push_back(mesh.owners[Index(found->second)] != side.cell);
        continue;
      }
      Add(face, mesh);
    }
  }
  mesh.patchStart.push_back(static_cast<Id>(mesh.owners.size()));
  const Id named = static_cast<Id>(mesh.owners.size() - mesh.neighbours.size());
  if (named != outer)
  {
    return InvalidInput("the mesh has " + std::to_string(outer) + " outer faces, but its patches " +
                        std::to_string(named) + ": run Fluid-Solid Mesh anew");
  }
  return mesh;
}

} // namespace lamina
