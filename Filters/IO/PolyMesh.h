// SPDX-License-Identifier: BSD-3-Clause
// A mesh by its faces, in the order that OpenFOAM demands.
#pragma once

#include "SaveJob.h"

namespace lamina
{

struct PolyMesh
{
  std::vector<Id> faces;  ///< four nodes a face, the fourth -1 for a triangle, seen from outside the owner
  std::vector<Id> owners; ///< of all faces: the lower cell
  std::vector<Id> neighbours; ///< of inner faces: the higher cell; these faces come first
  std::vector<Id> patchStart; ///< first face of each set of job.sides, and the end; none for inner sets
  std::vector<std::vector<Id>> zoneFaces;   ///< inner faces of each set of job.sides (shared interfaces)
  std::vector<std::vector<char>> zoneFlips; ///< 1 where the set's normal points against the face's
};

/// Inner faces in the order of owners, then neighbours; then the boundary, set by set. A failure if a face
/// belongs to more than two cells, or an outer one to no set.
Result<PolyMesh> MakePolyMesh(const SaveJob& job);

} // namespace lamina
