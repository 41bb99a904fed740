// SPDX-License-Identifier: BSD-3-Clause
// Surfaces from elsewhere, without BoundaryLabels.
#pragma once

#include "Stage.h"

#include "Base/Monitor.h"
#include "Mesh/TriangleComplex.h"

namespace lamina
{

/// Material 1 inside, background outside: each edge must have two triangles that run through it in opposite
/// directions. If the surface as a whole is inside out, all triangles are turned.
Status LabelPlainSurface(TriangleComplex& surface, Monitor& monitor);

} // namespace lamina
