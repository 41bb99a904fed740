// SPDX-License-Identifier: BSD-3-Clause
// What is told of cells and memory before anything is meshed, against the truth.
#include "Images.h"
#include "Sizing/FeatureSize.h"
#include "Sizing/RefinementDemand.h"
#include "Surface/ExtractInterfaces.h"
#include "Surface/RefineSurface.h"
#include "Surface/SmoothSurface.h"
#include "Volume/CoreTets.h"
#include "Volume/LayeredTets.h"
#include "Volume/MeshEstimate.h"
#include "Volume/PrismLayers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include <sys/resource.h>

using namespace lamina;

namespace
{

class SmallMachine : public ThreadMonitor
{
public:
  explicit SmallMachine(double bytes)
    : ThreadMonitor(2)
    , Bytes(bytes)
  {
  }
  double FreeMemory() override { return this->Bytes; }

private:
  double Bytes;
};

/// Tissue 1 around blood 2, with sizes for so many layers.
TriangleComplex SizedShell(int layers)
{
  const auto image = images::MakeCentred(40,
                                         [](double x, double y, double z)
                                         {
                                           const double r = std::sqrt(x * x + y * y + 1.5 * z * z);
                                           return r < 10 ? 2 : (r < 16 ? 1 : 0);
                                         });
  ThreadMonitor monitor(2);
  TriangleComplex surface;
  EXPECT_TRUE(ExtractInterfaces(image, surface, {}, monitor));
  EXPECT_TRUE(SmoothSurface(surface, {}, monitor));
  FeatureSizeOptions sizing;
  sizing.layers = layers;
  EXPECT_TRUE(ComputeFeatureSize(surface, sizing, monitor));
  return surface;
}

void ExpectNear(double estimate, double truth, const std::string& what)
{
  EXPECT_LT(std::abs(estimate / truth - 1), 0.25)
    << what << ": " << estimate << " told, " << truth << " made";
}

const MemoryDemand& StageOf(const MeshEstimate& estimate, const std::string& name)
{
  for (const PlannedStage& stage : estimate.stages)
  {
    if (stage.name == name)
    {
      return stage.demand;
    }
  }
  ADD_FAILURE() << "no stage " << name;
  return estimate.stages.front().demand;
}

/// In a process of its own: with 1.5 GiB of address space, less is free.
void FeelALimit()
{
  rlimit limit{ 3UL << 29, 3UL << 29 };
  setrlimit(RLIMIT_AS, &limit);
  const double free = FreeMemory();
  std::exit(free < 1.5 * BytesPerGiB && free > 0.1 * BytesPerGiB ? 0 : 1);
}

} // namespace

class MeshEstimateOfLayers : public testing::TestWithParam<int>
{
};

TEST_P(MeshEstimateOfLayers, IsWithinAQuarter)
{
  const int layers = GetParam();
  TriangleComplex surface = SizedShell(layers);
  MeshPlan plan;
  plan.solids = { 1 };
  plan.fluids = { 2 };
  plan.layers = layers;
  plan.prismLayers = 4;
  const MeshEstimate before = EstimateMesh(surface, plan);
  ThreadMonitor monitor(2);
  ASSERT_TRUE(RefineSurface(surface, {}, monitor));
  ExpectNear(StageOf(before, "Surface Refinement").cells, static_cast<double>(surface.triangles.size()),
             "triangles");
  LayersOnSurface onSurface;
  VolumeMesh tissue;
  LayeredTetsOptions solid;
  solid.materials = { 1 };
  solid.layers = layers;
  ASSERT_TRUE(MeshLayeredTets(surface, solid, tissue, onSurface, monitor));
  ExpectNear(StageOf(before, "Layered Tetrahedra").cells, static_cast<double>(tissue.CellCount()), "tissue");
  PrismLayersOptions fluid;
  fluid.materials = { 2 };
  fluid.layers = 4;
  VolumeMesh prisms;
  TriangleComplex front;
  ASSERT_TRUE(GrowPrismLayers(surface, fluid, prisms, front, onSurface, monitor));
  ExpectNear(StageOf(before, "Prism Layer").cells, static_cast<double>(prisms.CellCount()), "prisms");
  VolumeMesh core;
  ASSERT_TRUE(MeshCoreTets(front, {}, {}, core, monitor));
  const double all = static_cast<double>(tissue.CellCount() + prisms.CellCount() + core.CellCount());
  ExpectNear(before.cells, all, "all");
  // And of the refined surface.
  ExpectNear(EstimateMesh(surface, plan).cells, all, "all, once refined");
}

INSTANTIATE_TEST_SUITE_P(Layers, MeshEstimateOfLayers, testing::Values(3, 4, 6, 8));

TEST(MeshEstimate, AStageRefusesWhatTheMachineCannotHold)
{
  TriangleComplex surface = SizedShell(4);
  SmallMachine small(1e5);
  ThreadMonitor plain(2);
  const auto expect = [](const auto& result)
  {
    ASSERT_FALSE(result);
    EXPECT_EQ(result.GetError().kind, Failure::Unreachable);
    const std::string& text = result.GetError().message;
    EXPECT_NE(text.find("of memory, but only 0 MiB are free"), std::string::npos) << text;
  };
  const TriangleComplex before = surface;
  expect(RefineSurface(surface, {}, small));
  EXPECT_EQ(surface.points, before.points);
  ASSERT_TRUE(RefineSurface(surface, {}, plain));
  LayersOnSurface onSurface;
  VolumeMesh mesh;
  TriangleComplex front;
  LayeredTetsOptions solid;
  solid.materials = { 1 };
  expect(MeshLayeredTets(surface, solid, mesh, onSurface, small));
  PrismLayersOptions fluid;
  fluid.materials = { 2 };
  expect(GrowPrismLayers(surface, fluid, mesh, front, onSurface, small));
  expect(MeshCoreTets(surface, {}, {}, mesh, small));
  // An edge too short by mistake.
  surface.targetEdgeLength.assign(surface.points.size(), 1e-6);
  SmallMachine large(1e12);
  const auto refused = RefineSurface(surface, {}, large);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.GetError().message.find("M triangles"), std::string::npos) << refused.GetError().message;
}

TEST(MeshEstimate, ALongestEdgeInTheCoreCounts)
{
  const TriangleComplex surface = SizedShell(4);
  const std::vector<double> counts = AsItIs(surface);
  const double free = CoreTetsDemand(surface, counts, { 2 }, 0).cells;
  EXPECT_EQ(CoreTetsDemand(surface, counts, { 2 }, 100).cells, free);
  EXPECT_GT(CoreTetsDemand(surface, counts, { 2 }, 0.2).cells, 5 * free);
}

TEST(Memory, TheMachineTells)
{
  const double free = FreeMemory();
  EXPECT_GT(free, 0);
  EXPECT_LT(free, 1e15) << "this system does not tell";
  EXPECT_GT(PeakMemory(), 1e6);
  EXPECT_EQ(MemoryText(3.25 * BytesPerGiB), "3.2 GiB");
  EXPECT_EQ(MemoryText(20 * BytesPerGiB / 1024), "20 MiB");
}

TEST(Memory, ALimitOfTheProcessCounts)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers take terabytes of address space";
#endif
  EXPECT_EXIT(FeelALimit(), testing::ExitedWithCode(0), "");
}
