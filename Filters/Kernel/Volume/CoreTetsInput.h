// SPDX-License-Identifier: BSD-3-Clause
// What must hold before a core is filled.
#pragma once

#include "CoreTets.h"

#include <optional>

namespace lamina
{

std::optional<Error> CheckCoreOptions(const CoreTetsOptions& options);

/// The surface closes round every material and does not intersect itself, the interior points are finite.
/// Offending triangles go into the report.
std::optional<Error> CheckCoreSurface(const TriangleComplex& surface, const std::vector<Vec3>& interiorPoints,
                                      CoreTetsReport& report, Monitor& monitor);

/// The middles of triangles.
std::vector<Vec3> CentresOf(const TriangleComplex& surface, const std::vector<Id>& triangles);

} // namespace lamina
