// SPDX-License-Identifier: BSD-3-Clause
// How many cells the stages that fill a surface will make, and the memory they take for that.
#pragma once

#include "../Base/Memory.h"
#include "../Mesh/TriangleComplex.h"

#include <string>

namespace lamina
{

// `counts`: for how many triangles each triangle stands (AsItIs or TrianglesWanted in
// Sizing/RefinementDemand.h).

/// What Layered Tetrahedra makes in the solids.
MemoryDemand LayeredTetsDemand(const TriangleComplex& surface, const std::vector<double>& counts,
                               const std::vector<int>& solids, int layers);

/// What Prism Layer makes on the walls of the fluids.
MemoryDemand PrismsDemand(const TriangleComplex& surface, const std::vector<double>& counts,
                          const std::vector<int>& fluids, int layers);

/// What Core Tetrahedra makes in the materials, on a surface or its front; `maximumEdge` 0: no limit.
MemoryDemand CoreTetsDemand(const TriangleComplex& surface, const std::vector<double>& counts,
                            const std::vector<int>& materials, double maximumEdge);

/// What a surface is to become.
struct MeshPlan
{
  std::vector<int> solids;
  std::vector<int> fluids;
  int layers = 6;      ///< of tets across a solid's wall
  int prismLayers = 5; ///< on a fluid's walls; 0: none
};

struct PlannedStage
{
  std::string name;
  MemoryDemand demand;
};

struct MeshEstimate
{
  std::vector<PlannedStage> stages; ///< those that have something to do, in the order they run in
  double cells = 0;                 ///< of the whole mesh
  double bytes = 0;                 ///< at the peak of all stages, with what those before it have left
};

/// From Surface Refinement to Mesh Audit. A surface that has target edge lengths counts as it will be when it
/// is refined to them (one that is, gets the same). Measured against whole runs on phantoms and scans: cells
/// within a quarter.
MeshEstimate EstimateMesh(const TriangleComplex& surface, const MeshPlan& plan);

} // namespace lamina
