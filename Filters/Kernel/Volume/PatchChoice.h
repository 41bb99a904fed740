// SPDX-License-Identifier: BSD-3-Clause
// Walls of a volume mesh that a user names: patches by their names, or all between two materials.
#pragma once

#include "../Base/Result.h"
#include "../Mesh/MeshPatches.h"

namespace lamina
{

/// The faces of chosen patches as triangles, quads in halves.
///
/// `names` are patches' names, or pairs of materials such as "1-2" (0 is the outside); none stand for all
/// patches of `kind` on the boundary of `materials`. `what` is the wall's name in messages. An error if a
/// name fits no patch, or nothing is chosen.
Result<std::vector<Triangle>> ChoosePatches(const VolumeMesh& mesh, const MeshPatches& patches,
                                            const std::vector<std::string>& names, PatchKind kind,
                                            const std::vector<int>& materials, const char* what);

} // namespace lamina
