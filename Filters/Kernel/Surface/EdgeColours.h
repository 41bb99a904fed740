// SPDX-License-Identifier: BSD-3-Clause
// Which edges a sweep of smoothing relaxes, and in what order.
#pragma once

#include "SmoothingState.h"

namespace lamina
{

/// What is relaxed: edges whose ends are of one kind, and points without such an edge (b = -1).
std::vector<Edge> ChooseEdges(const SmoothingState& state);

/// Edges of one colour neither move nor read a point that another of them moves: a sweep through the colours
/// in order gives the same result for any number of threads. A relaxation reads the triangles around its ends
/// and theirs.
std::vector<std::vector<Edge>> ColourEdges(const SmoothingState& state, const std::vector<Edge>& edges);

} // namespace lamina
