// SPDX-License-Identifier: BSD-3-Clause
// Files of voxel edits: {"format": "Lamina voxel edits", "version": 1, "edits": [ ... ]}, the edits as in
// EditText.h.
#pragma once

#include "Base/Result.h"

#include <string>
#include <vector>

namespace lamina
{

/// The texts of the edits in a file; each has been parsed once.
Result<std::vector<std::string>> ReadEditFile(const std::string& path);
/// Write the edits to a file. Nothing half-written is left under its name.
Result<bool> WriteEditFile(const std::string& path, const std::vector<std::string>& edits);

} // namespace lamina
