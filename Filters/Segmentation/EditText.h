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

#include <string>
#include <vector>

namespace lamina
{

/// The edit that `text` describes; `name` stands in front of what is wrong with it.
Result<VoxelEdit> ParseEdit(const std::string& text, const std::string& name);
/// One line of JSON.
std::string WriteEdit(const VoxelEdit& edit);

/// The texts of the edits in a file; each has been parsed once.
Result<std::vector<std::string>> ReadEditFile(const std::string& path);
/// Write the edits to a file. Nothing half-written is left under its name.
Result<bool> WriteEditFile(const std::string& path, const std::vector<std::string>& edits);

} // namespace lamina
