// SPDX-License-Identifier: BSD-3-Clause
// Names as a user writes them: "1=tissue; 2=blood; wall_1_1=epicardium".
#pragma once

#include "Stage.h"

#include <map>

namespace lamina
{

/// What is to be named and how; a failure that shows the part that is not understood, or named twice.
Result<std::map<std::string, std::string>> ParseNames(const std::string& text);

/// "endo; septum" as a list; blanks around the names do not count.
std::vector<std::string> SplitNames(const std::string& text);

} // namespace lamina
