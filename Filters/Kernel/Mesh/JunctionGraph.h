// SPDX-License-Identifier: BSD-3-Clause
// Where sheets of a multimaterial surface meet: feature edges, junction curves and corners.
#pragma once

#include "Adjacency.h"

namespace lamina
{

/// True if the edge between these triangles is a feature: not exactly two triangles, or two that differ in
/// their materials or their patch. Junction curves are made of such edges.
bool IsFeatureEdge(const TriangleComplex& surface, const Id* begin, const Id* end);

/// Feature flags of all edges of `table`.
std::vector<char> FeatureEdges(const TriangleComplex& surface, const EdgeTable& table);

/// Fill junctionOrder and junctionKind. A point with no feature edge is on a sheet, with two on a curve, else
/// a corner; points of plane patches (any patch but 0) get JunctionInBorderPlane added.
void ClassifyJunctions(TriangleComplex& surface);

} // namespace lamina
