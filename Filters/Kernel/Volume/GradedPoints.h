// SPDX-License-Identifier: BSD-3-Clause
// Points inside a front of layers from which the core's sizes grow.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/TriangleComplex.h"

namespace lamina
{

/// Points above those of the surface whose last layer (`layerHeight`, a length) is thin against the surface's
/// edges, so that the first tets of the core are at most a few times as high as it. Left out are points too
/// near to another part of the surface or to one taken before. None without layerHeight.
std::vector<Vec3> GradedPoints(const TriangleComplex& surface, Monitor& monitor);

/// Takes of `points`, in their order, those that are farther than `spacing` times the lesser of both radii
/// from all taken before; radius 0 is never taken. Returns their indices.
std::vector<std::size_t> ThinOut(const std::vector<Vec3>& points, const std::vector<double>& radius,
                                 double spacing);

} // namespace lamina
