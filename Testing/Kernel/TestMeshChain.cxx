// SPDX-License-Identifier: BSD-3-Clause
// From labels to one mesh: every stage of the kernel in a row, judged by the audit.
#include "Images.h"
#include "Mesh/Audit.h"
#include "Mesh/VolumeCorrection.h"
#include "Sizing/FeatureSize.h"
#include "Surface/AuditSurface.h"
#include "Surface/CutVessel.h"
#include "Surface/ExtractInterfaces.h"
#include "Surface/RefineSurface.h"
#include "Surface/SmoothSurface.h"
#include "Volume/AssembleMesh.h"
#include "Volume/CoreTets.h"
#include "Volume/LayeredTets.h"
#include "Volume/PrismLayers.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace lamina;

namespace
{

/// Unwraps a stage's result, or fails with its message.
template<typename T>
T Demand(const Result<T>& result, const char* stage)
{
  EXPECT_TRUE(result) << stage << ": " << (result ? "" : result.GetError().message);
  return result ? *result : T{};
}

TriangleComplex MakeSurface(const LabelImage& image, const ExtractInterfacesOptions& options, int layers,
                            const std::vector<CutVesselOptions>& cuts = {})
{
  ThreadMonitor monitor(2);
  TriangleComplex surface;
  Demand(ExtractInterfaces(image, surface, options, monitor), "extract");
  Demand(SmoothSurface(surface, {}, monitor), "smooth");
  for (const CutVesselOptions& cut : cuts)
  {
    Demand(CutVessel(surface, cut, monitor), "cut");
  }
  FeatureSizeOptions sizing;
  sizing.layers = layers;
  Demand(ComputeFeatureSize(surface, sizing, monitor), "size");
  Demand(RefineSurface(surface, {}, monitor), "refine");
  std::vector<unsigned char> flags;
  const auto audit = Demand(AuditSurface(surface, flags, monitor), "audit surface");
  EXPECT_TRUE(audit.Passed()) << (audit.Passed() ? "" : audit.findings[0]);
  return surface;
}

/// Layered tets in the tissue 1, prisms and a core in the blood 2, all in one mesh.
VolumeMesh MakeMesh(const TriangleComplex& surface, int layers)
{
  ThreadMonitor monitor(2);
  LayersOnSurface onSurface;
  LayeredTetsOptions solid;
  solid.materials = { 1 };
  solid.layers = layers;
  VolumeMesh tissue;
  Demand(MeshLayeredTets(surface, solid, tissue, onSurface, monitor), "layered tets");
  PrismLayersOptions fluid;
  fluid.materials = { 2 };
  fluid.layers = 3;
  VolumeMesh prisms;
  TriangleComplex front;
  Demand(GrowPrismLayers(surface, fluid, prisms, front, onSurface, monitor), "prisms");
  VolumeMesh core;
  Demand(MeshCoreTets(front, {}, {}, core, monitor), "core");
  // The front's point ids are not the surface's.
  std::fill(core.interfaceNodeIds.begin(), core.interfaceNodeIds.end(), -1);
  VolumeMesh mesh;
  Demand(AssembleMesh({ &tissue, &prisms, &core }, {}, mesh, monitor), "assemble");
  return mesh;
}

void ExpectAuditPasses(const VolumeMesh& mesh, const TriangleComplex& surface)
{
  ThreadMonitor monitor(2);
  AuditMarks marks;
  const auto audit = Demand(AuditMesh(mesh, &surface, {}, marks, monitor), "audit mesh");
  for (const std::string& finding : audit.findings)
  {
    ADD_FAILURE() << finding;
  }
  EXPECT_EQ(audit.invertedCells, 0);
  EXPECT_EQ(audit.overlaps, 0);
  EXPECT_EQ(audit.interfaceMismatches, 0);
  EXPECT_GT(audit.interfaceTriangles, 0);
  EXPECT_LT(audit.largestVolumeError, 1e-9);
  ASSERT_EQ(audit.materials.size(), 2u);
  EXPECT_GT(audit.materials[0].tets, 0);
  EXPECT_GT(audit.materials[1].wedges, 0);
  for (const MaterialAudit& material : audit.materials)
  {
    EXPECT_EQ(material.components, 1) << material.material;
    EXPECT_GT(material.tetQualityMin, 0.1) << material.material;
  }
}

} // namespace

TEST(MeshChain, NestedBoxes)
{
  const auto image =
    images::MakeCentred(18,
                        [](double x, double y, double z)
                        {
                          const double r = std::max({ std::abs(x), std::abs(y), std::abs(z) });
                          return r < 4 ? 2 : (r < 8 ? 1 : 0);
                        });
  const TriangleComplex surface = MakeSurface(image, {}, 4);
  const auto volumes = MaterialVolumes(surface, { 1, 2 });
  EXPECT_NEAR(volumes[0], images::CountOf(image, 1), 1e-6 * volumes[0]);
  EXPECT_NEAR(volumes[1], images::CountOf(image, 2), 1e-6 * volumes[1]);
  ExpectAuditPasses(MakeMesh(surface, 4), surface);
}

TEST(MeshChain, OpenTube)
{
  const auto image = images::Make({ { 20, 20, 16 } },
                                  [](Id i, Id j, Id)
                                  {
                                    const double x = static_cast<double>(i) - 9.5;
                                    const double y = static_cast<double>(j) - 9.5;
                                    const double r = std::sqrt(x * x + y * y);
                                    return r < 4.6 ? 2 : (r < 8.6 ? 1 : 0);
                                  });
  ExtractInterfacesOptions options;
  options.openMaterials = { 2 };
  options.openAtImageBorder = true;
  const TriangleComplex surface = MakeSurface(image, options, 3);
  ExpectAuditPasses(MakeMesh(surface, 3), surface);
}

TEST(MeshChain, VesselCutByObliquePlanes)
{
  const auto image = images::Make({ { 22, 22, 30 } },
                                  [](Id i, Id j, Id k)
                                  {
                                    const double x = static_cast<double>(i) - 10.5;
                                    const double y = static_cast<double>(j) - 10.5;
                                    const double r = std::sqrt(x * x + y * y);
                                    const Id ends = std::min(k, 29 - k);
                                    return ends > 4 && r < 4.6 ? 2 : (ends > 1 && r < 8.6 ? 1 : 0);
                                  });
  CutVesselOptions top;
  top.origin = { 10.5, 10.5, 21 };
  top.normal = { 0.3, 0.1, 1 };
  CutVesselOptions bottom;
  bottom.origin = { 10.5, 10.5, 9 };
  bottom.normal = { 0.2, 0, -1 };
  const TriangleComplex surface = MakeSurface(image, {}, 3, { top, bottom });
  ExpectAuditPasses(MakeMesh(surface, 3), surface);
}
