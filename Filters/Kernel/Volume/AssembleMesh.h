// SPDX-License-Identifier: BSD-3-Clause
// One mesh from parts that share bit-identical points.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/VolumeMesh.h"

namespace lamina
{

struct AssembleMeshOptions
{
  double scale = 1; ///< factor on all coordinates at the end, > 0
};

struct AssembleMeshReport
{
  Id points = 0;
  Id cells = 0;
  Id mergedPoints = 0; ///< points that occurred in more than one part
};

/// Join the parts; points with equal coordinates (bit for bit) become one.
Result<AssembleMeshReport> AssembleMesh(const std::vector<const VolumeMesh*>& parts,
                                        const AssembleMeshOptions& options, VolumeMesh& mesh,
                                        Monitor& monitor);

} // namespace lamina
