// SPDX-License-Identifier: BSD-3-Clause
// The audit's part on sizes: edges of the surface against what refinement aimed at.
#pragma once

#include "../Base/Result.h"
#include "../Mesh/TriangleComplex.h"

namespace lamina
{

struct SizeAudit
{
  Id edges = 0;
  std::array<double, 5> percentiles{ { 1, 1, 1, 1,
                                       1 } }; ///< of length over TargetEdgeLength: 1, 5, 50, 95, 99
  double share = 1;                           ///< of edges from half to twice the target
};

/// Compares each edge with the mean TargetEdgeLength of its ends. No edges if the surface has no such array.
SizeAudit AuditSizes(const TriangleComplex& surface);

} // namespace lamina
