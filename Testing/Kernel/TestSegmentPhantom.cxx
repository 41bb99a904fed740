// SPDX-License-Identifier: BSD-3-Clause
// The segmentation of the phantom heart against its truth: small in the quick run, at 240 voxels in the long
// one.
#include "PhantomScores.h"

#include "Mesh/WellComposed.h"

#include <gtest/gtest.h>

#include <cstdio>

using namespace lamina;
using namespace lamina::scores;

namespace
{

struct Gates
{
  int resolution;
  double noise;
  double blood; ///< least Dice
  double tissue;
  double coronaries; ///< those at most 3.5 voxels thick
  double strands;
};

Phantom MakePhantom(int resolution, double noise)
{
  HeartPhantomOptions options;
  options.resolution = resolution;
  options.noise = noise;
  Phantom phantom;
  ThreadMonitor monitor(2);
  const auto report = MakeHeartPhantom(phantom.grey, phantom.truth, options, monitor);
  EXPECT_TRUE(report) << report.GetError().message;
  phantom.report = *report;
  return phantom;
}

struct Segmented
{
  LabelImage labels;
  std::vector<unsigned char> flags;
  SegmentReport report;
};

Segmented SegmentPhantom(const Phantom& phantom, const SegmentOptions& options = {}, int threads = 2)
{
  Segmented result;
  ThreadMonitor monitor(threads);
  const auto report = Segment(phantom.grey, result.labels, result.flags, options, monitor);
  EXPECT_TRUE(report) << report.GetError().message;
  result.report = *report;
  return result;
}

void CheckOverlap(const Phantom& phantom, const LabelImage& found, const Gates& gates)
{
  const double blood = DiceOf(phantom, found, Blood);
  const double tissue = DiceOf(phantom, found, Tissue);
  const double coronaries = DiceOfRods(phantom, found, HeartPart::Coronary, 3.5);
  const double allCoronaries = DiceOfRods(phantom, found, HeartPart::Coronary, 1e9);
  const double strands = DiceOfRods(phantom, found, HeartPart::Strand, 1e9);
  std::printf("resolution %d, noise %g: Dice blood %.4f tissue %.4f coronaries of 3 voxels %.4f all %.4f "
              "strands %.4f\n",
              gates.resolution, gates.noise, blood, tissue, coronaries, allCoronaries, strands);
  EXPECT_GE(blood, gates.blood);
  EXPECT_GE(tissue, gates.tissue);
  EXPECT_GE(coronaries, gates.coronaries);
  EXPECT_GE(allCoronaries, gates.coronaries);
  EXPECT_GE(strands, gates.strands);
}

void CheckTopology(const Phantom& phantom, const Segmented& found)
{
  for (std::size_t m = 0; m < 3; ++m)
  {
    const BettiNumbers& betti = found.report.after[m];
    std::printf("  material %zu: b0 %lld b1 %lld b2 %lld (thresholds %lld %lld %lld)\n", m, betti.b0,
                betti.b1, betti.b2, found.report.before[m].b0, found.report.before[m].b1,
                found.report.before[m].b2);
    EXPECT_EQ(betti.b0, phantom.report.materials[m].components) << "material " << m;
    // The rules dig few tunnels of their own.
    EXPECT_LE(betti.b1, found.report.before[m].b1 + 6) << "material " << m;
  }
  ThreadMonitor monitor(2);
  RepairOptions rules;
  rules.forbidden = { { { Background, Blood } } };
  EXPECT_TRUE(FindTopologyFaults(found.labels, rules, monitor).empty());
  const auto coronaries = BrokenCoronaries(phantom, found.labels, 3);
  const auto strands = BrokenStrands(phantom, found.labels);
  EXPECT_EQ(coronaries.first, 0) << "of " << coronaries.second;
  EXPECT_EQ(coronaries.second, 8);
  EXPECT_EQ(strands.first, 0) << "of " << strands.second;
}

/// Of the true tissue that is thin and found, skins and repair take almost nothing.
void CheckThinTissue(const Phantom& phantom, const LabelImage& found, double least)
{
  SegmentOptions without;
  without.dissolveSkins = false;
  without.repair = TopologyRepair::Off;
  const Segmented plain = SegmentPhantom(phantom, without);
  Id had = 0;
  Id kept = 0;
  for (const Id v : ThinTissue(phantom.truth))
  {
    had += plain.labels.labels[v] == Tissue;
    kept += plain.labels.labels[v] == Tissue && found.labels[v] == Tissue;
  }
  std::printf("  thin tissue: %lld voxels, kept by skins and repair %lld\n", had, kept);
  ASSERT_GT(had, 500);
  EXPECT_GE(static_cast<double>(kept), least * static_cast<double>(had));
}

void CheckAll(const Gates& gates)
{
  const Phantom phantom = MakePhantom(gates.resolution, gates.noise);
  const Segmented found = SegmentPhantom(phantom);
  CheckOverlap(phantom, found.labels, gates);
  CheckTopology(phantom, found);
  CheckThinTissue(phantom, found.labels, 0.999);
}

} // namespace

TEST(SegmentPhantom, AtLowResolution)
{
  CheckAll({ 96, 12, 0.96, 0.96, 0.85, 0.85 });
}

TEST(SegmentPhantom, ThreadsDoNotMatter)
{
  const Phantom phantom = MakePhantom(80, 20);
  const Segmented one = SegmentPhantom(phantom, {}, 1);
  const Segmented three = SegmentPhantom(phantom, {}, 3);
  EXPECT_EQ(one.labels.labels, three.labels.labels);
  EXPECT_EQ(one.flags, three.flags);
}

TEST(LongSegmentPhantom, AtFullResolution)
{
  CheckAll({ 240, 12, 0.98, 0.98, 0.85, 0.9 });
}

TEST(LongSegmentPhantom, InMuchNoise)
{
  const Gates gates{ 240, 20, 0.97, 0.97, 0.8, 0.9 };
  const Phantom phantom = MakePhantom(gates.resolution, gates.noise);
  const Segmented found = SegmentPhantom(phantom);
  CheckOverlap(phantom, found.labels, gates);
  CheckTopology(phantom, found);
}
