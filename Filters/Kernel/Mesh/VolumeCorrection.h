// SPDX-License-Identifier: BSD-3-Clause
// Enclosed volumes of materials, and bringing them back after a change.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "Adjacency.h"

#include <optional>

namespace lamina
{

/// Sheets (triangles connected through edges that are no features) and shells (connected pieces of one
/// material's boundary). A sheet lies wholly on one shell of either side, so operations that keep sheets keep
/// shells.
struct SheetGraph
{
  std::vector<int> sheetOfTriangle;
  std::vector<std::array<int, 2>>
    shellsOfSheet; ///< of the pair's first and second material; -1 for background
  std::vector<int> materialOfShell;

  int ShellCount() const { return static_cast<int>(this->materialOfShell.size()); }
};
/// With `background`, material 0 has shells too.
SheetGraph MakeSheetGraph(const TriangleComplex& surface, bool background = false);

/// The signed volume enclosed by every shell (negative for a cavity), by the divergence theorem about a local
/// origin.
std::vector<double> ShellVolumes(const TriangleComplex& surface, const SheetGraph& graph);

/// The volume enclosed by every material of `materials`.
std::vector<double> MaterialVolumes(const TriangleComplex& surface, const std::vector<int>& materials);

/// An error if a material's boundary encloses no positive volume: it is turned the wrong way, or flat.
std::optional<Error> CheckSides(const TriangleComplex& surface, const std::vector<int>& materials);

/// Move the inner points of every sheet along their normals, all of one sheet by the same small height, so
/// that each shell encloses its target again: the least such change, by Newton's method. Points of curves,
/// corners and plane patches stay. `reach` (one a point, or empty) tells how far each may move at most: what
/// some cannot do, others do. Returns the largest remaining volume error relative to the shell's volume.
double RestoreVolumes(TriangleComplex& surface, const SheetGraph& graph, const std::vector<double>& targets,
                      const std::vector<double>& reach = {});

} // namespace lamina
