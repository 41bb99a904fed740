// SPDX-License-Identifier: BSD-3-Clause
// The named patches of a volume mesh: interfaces between materials, walls, plane ends and openings.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "CellFaces.h"
#include "TriangleComplex.h"
#include "VolumeMesh.h"

#include <map>

namespace lamina
{

enum class PatchKind : int
{
  Interface = 0, ///< between two meshed materials
  Wall = 1,      ///< outer boundary
  Border = 2,    ///< outer boundary in a plane where the image ends
  Opening = 3    ///< plane end through which a material is meant to go on
};

/// A connected piece of boundary of one kind and material pair.
struct MeshPatch
{
  std::string name;
  PatchKind kind = PatchKind::Wall;
  MaterialPair pair; ///< second 0 for outer boundaries
  Id faces = 0;
  double area = 0;
  Vec3 centre; ///< of area
};

/// A face of a patch: face `face` (CellFaces.h) of `cell`, which is of the patch's first material; on an
/// interface also the same face as the cell of the second material has it, else -1.
struct PatchFace
{
  Id cell = -1;
  int face = -1;
  int patch = -1;
  Id otherCell = -1;
  int otherFace = -1;
};

struct MeshPatches
{
  std::vector<MeshPatch> patches;
  std::vector<PatchFace> faces; ///< ascending by patch, then by their corners
  std::map<int, std::string> materialNames;
};

struct FindPatchesOptions
{
  double surfaceScale = 1; ///< factor on the surface's coordinates to match the mesh, > 0
  /// "1" or a patch's own name -> the name to use instead; materials' names go into those of their patches.
  std::map<std::string, std::string> names;
};

struct FindPatchesReport
{
  Id patches = 0;
  Id faces = 0;
  std::vector<std::string> unusedNames; ///< entries of options.names that nothing answers to
};

/// Find and name all patches of a mesh. With `surface` (may be null), whose patches tell openings and plane
/// ends; without it all outer faces are walls. Names are interface_A_B_n, wall_A_n, border_A_n and
/// opening_A_n of materials A < B, with n from 1 in an order of size and place (PieceOrder.h); plane patches
/// to which the surface gives a name (opening_aorta, not opening_1) keep it. `known` are the mesh's faces,
/// where somebody has found them already.
Result<FindPatchesReport> FindPatches(const VolumeMesh& mesh, const TriangleComplex* surface,
                                      const FindPatchesOptions& options, MeshPatches& patches,
                                      Monitor& monitor, const CellFaces* known = nullptr);

/// Count a face, its fourth corner -1 for a triangle, towards its patch: faces, area, and the centre times
/// the area.
void AddToPatch(const VolumeMesh& mesh, const std::array<Id, 4>& corners, MeshPatch& patch);

/// The name of a material: its own, else "material_<id>".
std::string MaterialName(const std::map<int, std::string>& names, int material);

} // namespace lamina
