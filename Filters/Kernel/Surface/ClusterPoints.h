// SPDX-License-Identifier: BSD-3-Clause
// Points of an extracted surface that stand close together, merged.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/TriangleComplex.h"

namespace lamina
{

/// Merges the ends of edges shorter than `length`, shortest first, for fewer and better triangles, in the
/// manner of Z. Wu and J. M. Sullivan, Int. J. Numer. Meth. Eng. 58 (2003) 189-207. The topology of the
/// complex stays: junction curves, corners, patches and their planes too. No triangles intersect, and no
/// point of the old surface lies farther from the new one than `tolerance`, nor the other way round. What a
/// piece loses or gains in volume, and the missing volumes of triangles that went, are added to the missing
/// volumes of the triangles nearby. A surface without such edges is left as it is. Returns the number of
/// merged points; nothing is changed if cancelled.
Id ClusterPoints(TriangleComplex& surface, double length, double tolerance, Monitor& monitor);

} // namespace lamina
