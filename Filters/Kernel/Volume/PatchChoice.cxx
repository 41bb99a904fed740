// SPDX-License-Identifier: BSD-3-Clause
#include "PatchChoice.h"

#include <algorithm>
#include <cstdio>

namespace lamina
{
namespace
{

bool Contains(const std::vector<int>& list, int value)
{
  return std::find(list.begin(), list.end(), value) != list.end();
}

/// "1-2", in any order, as the pair of a patch.
bool IsPairOf(const std::string& name, const MaterialPair& pair)
{
  int first = -1;
  int second = -1;
  int used = 0;
  if (std::sscanf(name.c_str(), "%d-%d%n", &first, &second, &used) != 2 ||
      used != static_cast<int>(name.size()))
  {
    return false;
  }
  return (first == pair.first && second == pair.second) || (first == pair.second && second == pair.first);
}

/// The border of the materials: between two of them there is no wall.
bool IsOnBoundary(const MeshPatch& patch, const std::vector<int>& materials)
{
  return Contains(materials, patch.pair.first) != Contains(materials, patch.pair.second);
}

} // namespace

Result<std::vector<Triangle>> ChoosePatches(const VolumeMesh& mesh, const MeshPatches& patches,
                                            const std::vector<std::string>& names, PatchKind kind,
                                            const std::vector<int>& materials, const char* what)
{
  std::vector<char> isChosen(patches.patches.size(), 0);
  for (std::size_t p = 0; names.empty() && p < isChosen.size(); ++p)
  {
    const MeshPatch& patch = patches.patches[p];
    isChosen[p] = patch.kind == kind && IsOnBoundary(patch, materials) ? 1 : 0;
  }
  for (const std::string& name : names)
  {
    bool isKnown = false;
    for (std::size_t p = 0; p < isChosen.size(); ++p)
    {
      const MeshPatch& patch = patches.patches[p];
      // Ends through which a material goes on are no walls, unless by their own name.
      const bool isWall = patch.kind == PatchKind::Interface || patch.kind == PatchKind::Wall;
      if (patch.name == name || (isWall && IsPairOf(name, patch.pair)))
      {
        isChosen[p] = 1;
        isKnown = true;
      }
    }
    if (!isKnown)
    {
      return InvalidOption(std::string(what) + ": there is no patch " + name +
                           "; see the table of patches of Fluid-Solid Mesh");
    }
  }
  if (std::find(isChosen.begin(), isChosen.end(), 1) == isChosen.end())
  {
    return InvalidInput(std::string("there is no ") + what +
                        ": name the patches that are it, or choose other materials");
  }
  std::vector<Triangle> triangles;
  for (const PatchFace& face : patches.faces)
  {
    if (isChosen[static_cast<std::size_t>(face.patch)] == 0)
    {
      continue;
    }
    const CellFace c = FaceOf(mesh, face.cell, face.face);
    for (std::size_t k = 1; k < (c.IsQuad() ? 3u : 2u); ++k)
    {
      triangles.push_back({ { c.corners[0], c.corners[k], c.corners[k + 1] } });
    }
  }
  return triangles;
}

} // namespace lamina
