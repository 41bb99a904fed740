// SPDX-License-Identifier: BSD-3-Clause
// What became of a refined surface.
#pragma once

#include "../Mesh/TriangleComplex.h"
#include "RefineSurface.h"
#include "StretchField.h"

namespace lamina
{

/// Fills in what the edges and triangles are like. `stretches`: the metric of lengths and qualities, one a
/// point, or none.
void MeasureRefined(const TriangleComplex& surface, const std::vector<Stretch>& stretches,
                    RefineSurfaceReport& report);

} // namespace lamina
