// SPDX-License-Identifier: BSD-3-Clause
// Edits of voxels as JSON: one object an edit, so that state files and scripts can hold them, and a file of
// several.
//
//   {"shape": "box", "bounds": [x0, x1, y0, y1, z0, z1], "to": 2}
//   {"shape": "sphere", "center": [x, y, z], "radius": r, "from": [0, 1], "to": 2}
//   {"shape": "voxels", "dimensions": [nx, ny, nz], "ids": [17, [20, 31]], "to": 0}
//
// Lengths are in world coordinates. "from" restricts an edit to voxels of these materials. Ids are indices of
// the image's points, [first, last] a run of them; "dimensions" is the size of the image they are of.
#pragma once

#include "Segmentation/Reassign.h"

#include <exception>
#include <string>

namespace lamina
{

/// The edit that `text` describes; `name` stands in front of what is wrong with it.
Result<VoxelEdit> ParseEdit(const std::string& text, const std::string& name);
/// One line of JSON.
std::string WriteEdit(const VoxelEdit& edit);

/// A message of the JSON library without its own numbering in front: "parse error at line 1, column 7: ...".
std::string PlainMessage(const std::exception& error);

} // namespace lamina
