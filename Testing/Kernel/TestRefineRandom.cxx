// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of random images through smoothing, sizing and refinement: what is guaranteed for every surface.
#include "Mesh/Closedness.h"
#include "RefinementGates.h"
#include "Sizing/FeatureSize.h"
#include "SmoothChecks.h"

using namespace lamina;

namespace
{

/// `blurs`: how often the fields that decide about the labels are averaged over neighbours.
void ExpectRefined(Id size, int labels, unsigned seed, int blurs)
{
  const std::string what = std::to_string(labels) + " labels in " + std::to_string(size) + "^3, seed " +
                           std::to_string(seed) + ", " + std::to_string(blurs) + " blurs";
  std::printf("%s\n", what.c_str());
  ThreadMonitor monitor(2);
  TriangleComplex surface;
  ASSERT_TRUE(ExtractInterfaces(checks::RandomLabels(size, labels, seed, blurs), surface, {}, monitor))
    << what;
  ASSERT_TRUE(SmoothSurface(surface, {}, monitor)) << what;
  ASSERT_TRUE(ComputeFeatureSize(surface, {}, monitor)) << what;
  const TriangleComplex before = surface;
  const auto report = RefineSurface(surface, {}, monitor);
  ASSERT_TRUE(report) << what << ": " << report.GetError().message;
  EXPECT_FALSE(CheckClosed(surface, true, monitor)) << what;
  constexpr double voxel = 1;
  const auto figures = measures::Measure(before, surface, {}, voxel, false, monitor);
  for (const std::string& broken : measures::BrokenGuarantees(figures, *report))
  {
    ADD_FAILURE() << what << ": " << broken;
  }
  EXPECT_LE(figures.hidden, report->forbiddenNodes) << what;
}

} // namespace

TEST(RefineRandom, FewImages)
{
  for (unsigned seed = 0; seed < 3; ++seed)
  {
    ExpectRefined(9 + static_cast<Id>(seed), 2 + static_cast<int>(seed), seed, 1);
  }
}

TEST(RefineRandom, TheLastHiddenNodesAreUncoveredBySplits)
{
  ExpectRefined(11, 4, 2, 1);  // a curve that turns sharply beside the border
  ExpectRefined(10, 5, 30, 1); // one of three corners stays that the input forbids
}

TEST(LongRefineRandom, FiftyImages)
{
  for (unsigned seed = 100; seed < 150; ++seed)
  {
    ExpectRefined(12 + static_cast<Id>(seed * 7 % 13), 2 + static_cast<int>(seed % 5), seed,
                  1 + static_cast<int>(seed % 3));
  }
}
