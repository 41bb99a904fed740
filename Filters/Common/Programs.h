// SPDX-License-Identifier: BSD-3-Clause
// Programs that the plugin brings along and starts.
#pragma once

#include <string>

namespace lamina
{

/// The full path of a program that stands beside this library, or up to two folders above it; empty if there
/// is none.
std::string FindProgram(const char* name);

} // namespace lamina
