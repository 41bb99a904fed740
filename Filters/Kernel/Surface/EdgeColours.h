// SPDX-License-Identifier: BSD-3-Clause
// Which edges a sweep of smoothing relaxes, and in what order.
#pragma once

#include "SmoothingState.h"

namespace lamina
{

/// What is relaxed: an edge of the table, or -1 - p for a point p on its own.
using Relaxable = Id;
inline Edge EndsOf(const SmoothingState& state, Relaxable which)
{
  return which < 0 ? Edge{ -1 - which, -1 } : state.table.edges[static_cast<std::size_t>(which)];
}

/// Edges whose ends are of one kind, and points without such an edge.
std::vector<Relaxable> ChooseEdges(const SmoothingState& state);

/// Edges of one colour neither move nor read a point that another of them moves: a sweep through the colours
/// in order gives the same result for any number of threads. A relaxation reads the triangles around its ends
/// and theirs.
std::vector<std::vector<Relaxable>> ColourEdges(const SmoothingState& state,
                                                const std::vector<Relaxable>& chosen);

} // namespace lamina
