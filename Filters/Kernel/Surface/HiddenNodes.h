// SPDX-License-Identifier: BSD-3-Clause
// Nodes from which no direction into a material sees all its faces, and which of them the input forbids to be
// any better.
#pragma once

#include "InputSurface.h"
#include "RefineSurface.h"

namespace lamina
{

/// Fills in hiddenNodes, hiddenPoints, hiddenPlaces and forbiddenNodes. `sheets` are those of the refined
/// triangles, in the numbers of the input.
///
/// The input forbids a node to see its faces if none of its own places does that the node could take. For a
/// node on a junction curve these are the edges of that curve within the tolerance: at the best of them the
/// sheets meet at less than twice asin(0.4), 47 degrees, or so many meet that no direction serves all; or the
/// curve turns so sharply that all that its sheets have within the tolerance leaves no direction together. A
/// corner stays the corner that it was: the input forbids it if it does not see its faces there either. For a
/// node within a sheet, at a ridge or a tip of the input, it is all that the input has within twice the
/// tolerance, seen together: the node may lie off the ridge.
void FindHiddenNodes(const TriangleComplex& surface, const SheetGraph& sheets, const InputSurface& input,
                     RefineSurfaceReport& report, Monitor& monitor);

/// Per point 1 if for some material no direction sees all its faces there, else 0. `star`: the triangles of
/// the points.
std::vector<char> HiddenFlags(const TriangleComplex& surface, const Lists& star, Monitor& monitor);

} // namespace lamina
