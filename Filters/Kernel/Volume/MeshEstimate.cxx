// SPDX-License-Identifier: BSD-3-Clause
#include "MeshEstimate.h"

#include "../Mesh/Adjacency.h"
#include "../Mesh/VolumeCorrection.h"
#include "../Sizing/RefinementDemand.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

namespace
{

/// Cells of a core over the triangles of its front: TetGen refines until no tet is worse than the radius-edge
/// ratio asks, and sizes grow inwards as fast as that allows, so that there are at most so many even in
/// the deepest core. In a solid the core is the middle layer, or the two with points between them.
constexpr double MostCorePerTriangle = 3.9;
constexpr double CoreGrowth = 0.5; ///< of edges over the distance from the front
constexpr double MiddlePerTriangle = 3.2;
constexpr double OddMiddlePerTriangle = 1.8;
/// Volume of a regular tet with edges of 1, and how many more tets fill a space of that size.
constexpr double UnitVolume = 0.11785113019775793;
constexpr double MoreThanRegular = 1.6;

// Bytes, measured at the peaks of the stages.
constexpr double KeptPerTet = 64;
constexpr double KeptPerPrism = 90;
constexpr double BytesPerLayeredTet = 450;
constexpr double BytesPerPrism = 330;
constexpr double BytesPerCoreTet = 1000;
constexpr double BytesPerMeshCell = 300;
constexpr double BytesPerAuditedCell = 290;

double TrianglesOf(const TriangleComplex& surface, const std::vector<double>& counts, int material,
                   bool isWallOnly)
{
  double sum = 0;
  for (std::size_t t = 0; t < counts.size(); ++t)
  {
    const bool isOpen = isWallOnly && IsOpening(surface, surface.Patch(static_cast<Id>(t)));
    sum += !isOpen && SideOf(surface.materials[t], material) != 0 ? counts[t] : 0;
  }
  return sum;
}

/// How many edges deep a material is behind its boundary: half the width of a slab in edges.
double DepthInEdges(const TriangleComplex& surface, const std::vector<double>& counts, int material,
                    double volume)
{
  double layer = 0; // the volume of a layer one edge thick
  for (std::size_t t = 0; t < counts.size(); ++t)
  {
    const double area = 0.5 * Norm(AreaVector2(surface.points, surface.triangles[t]));
    layer +=
      SideOf(surface.materials[t], material) != 0 ? area * std::sqrt(area / (UnitArea * counts[t])) : 0;
  }
  return layer > 0 ? std::abs(volume) / layer : 0;
}

MemoryDemand Sum(const MemoryDemand& a, const MemoryDemand& b)
{
  // One material after the other: the second works beside what the first has left.
  return { a.cells + b.cells, std::max(a.bytes, a.kept + b.bytes), a.kept + b.kept };
}

void Add(const char* name, const MemoryDemand& demand, MeshEstimate& estimate)
{
  if (demand.cells > 0)
  {
    estimate.stages.push_back({ name, demand });
  }
}

} // namespace

MemoryDemand LayeredTetsDemand(const TriangleComplex& surface, const std::vector<double>& counts,
                               const std::vector<int>& solids, int layers)
{
  const int columnLayers = std::max(0, (layers - 1) / 2); // on each wall; the middle is the core's
  const double middle = layers % 2 == 0 ? MiddlePerTriangle : OddMiddlePerTriangle;
  MemoryDemand all;
  for (int material : solids)
  {
    const double cells = (3 * columnLayers + middle) * TrianglesOf(surface, counts, material, false);
    all = Sum(all, { cells, BytesPerLayeredTet * cells, KeptPerTet * cells });
  }
  return all;
}

MemoryDemand PrismsDemand(const TriangleComplex& surface, const std::vector<double>& counts,
                          const std::vector<int>& fluids, int layers)
{
  MemoryDemand all;
  for (int material : fluids)
  {
    const double cells = layers * TrianglesOf(surface, counts, material, true);
    all = Sum(all, { cells, BytesPerPrism * cells, KeptPerPrism * cells });
  }
  return all;
}

MemoryDemand CoreTetsDemand(const TriangleComplex& surface, const std::vector<double>& counts,
                            const std::vector<int>& materials, double maximumEdge)
{
  double cells = 0;
  const std::vector<double> volumes = MaterialVolumes(surface, materials);
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    const double depth = DepthInEdges(surface, counts, materials[m], volumes[m]);
    const double onFront = MostCorePerTriangle * (1 - 1 / std::pow(1 + CoreGrowth * depth, 2)) *
                           TrianglesOf(surface, counts, materials[m], false);
    const double tet = UnitVolume * maximumEdge * maximumEdge * maximumEdge;
    cells += maximumEdge > 0 ? std::max(onFront, MoreThanRegular * std::abs(volumes[m]) / tet) : onFront;
  }
  return { cells, BytesPerCoreTet * cells, KeptPerTet * cells }; // all materials at once
}

MeshEstimate EstimateMesh(const TriangleComplex& surface, const MeshPlan& plan)
{
  const std::vector<double> counts = TrianglesWanted(surface);
  MeshEstimate estimate;
  Add("Surface Refinement", RefinementDemand(surface), estimate);
  const MemoryDemand solid = LayeredTetsDemand(surface, counts, plan.solids, plan.layers);
  const MemoryDemand prisms = PrismsDemand(surface, counts, plan.fluids, plan.prismLayers);
  const MemoryDemand core = CoreTetsDemand(surface, counts, plan.fluids, 0);
  Add("Layered Tetrahedra", solid, estimate);
  Add("Prism Layer", prisms, estimate);
  Add("Core Tetrahedra", core, estimate);
  estimate.cells = solid.cells + prisms.cells + core.cells;
  Add("Fluid-Solid Mesh",
      { estimate.cells, BytesPerMeshCell * estimate.cells, KeptPerPrism * estimate.cells }, estimate);
  Add("Mesh Audit", { estimate.cells, BytesPerAuditedCell * estimate.cells, KeptPerPrism * estimate.cells },
      estimate);
  double kept = 0;
  for (const PlannedStage& stage : estimate.stages)
  {
    estimate.bytes = std::max(estimate.bytes, kept + stage.demand.bytes);
    kept += stage.demand.kept;
  }
  return estimate;
}

} // namespace lamina
