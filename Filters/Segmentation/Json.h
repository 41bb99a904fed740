// SPDX-License-Identifier: BSD-3-Clause
// The library for JSON: VTK's copy where VTK comes with one, else the system's.
#pragma once

#if VTK_MODULE_ENABLE_VTK_nlohmannjson
#include <vtk_nlohmannjson.h>
#include VTK_NLOHMANN_JSON(json.hpp)
#else
#include <nlohmann/json.hpp>
#endif

namespace lamina
{

using Json = nlohmann::json;

} // namespace lamina
