// SPDX-License-Identifier: BSD-3-Clause
#include "Images.h"
#include "Mesh/WellComposed.h"
#include "Segmentation/Reassign.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

using namespace lamina;

namespace
{

LabelImage Uniform(Id n, int label)
{
  return images::Make({ { n, n, n } }, [=](Id, Id, Id) { return label; });
}

VoxelEdit Box(const Vec3& low, const Vec3& high, int to)
{
  VoxelEdit edit;
  edit.name = "edit 1";
  edit.shape = EditShape::Box;
  edit.low = low;
  edit.high = high;
  edit.to = to;
  return edit;
}

VoxelEdit Ball(const Vec3& centre, double radius, int to)
{
  VoxelEdit edit;
  edit.name = "edit 1";
  edit.shape = EditShape::Sphere;
  edit.centre = centre;
  edit.radius = radius;
  edit.to = to;
  return edit;
}

VoxelEdit List(std::vector<Id> voxels, int to)
{
  VoxelEdit edit;
  edit.name = "edit 1";
  edit.voxels = std::move(voxels);
  edit.to = to;
  return edit;
}

/// Without repair, so that what an edit does is seen alone.
ReassignOptions Plain(std::vector<VoxelEdit> edits)
{
  ReassignOptions options;
  options.edits = std::move(edits);
  options.repairTopology = false;
  return options;
}

std::vector<Id> VoxelsOf(const LabelImage& image, int label)
{
  std::vector<Id> ids;
  for (std::size_t v = 0; v < image.labels.size(); ++v)
  {
    if (image.labels[v] == label)
    {
      ids.push_back(static_cast<Id>(v));
    }
  }
  return ids;
}

Result<ReassignReport> Edited(LabelImage& image, const ReassignOptions& options, int threads = 1)
{
  ThreadMonitor monitor(threads);
  std::vector<unsigned char> decisions;
  return Reassign(image, decisions, options, monitor);
}

void ExpectFailure(const ReassignOptions& options, const std::string& part)
{
  LabelImage image = Uniform(4, 1);
  const LabelImage before = image;
  const auto report = Edited(image, options);
  ASSERT_FALSE(report) << part;
  EXPECT_NE(report.GetError().message.find(part), std::string::npos) << report.GetError().message;
  EXPECT_EQ(image.labels, before.labels);
}

/// A turned, anisotropic grid far from the origin, on which a place's voxel is found by another way: by
/// trying all.
GridGeometry Turned(Id n)
{
  GridGeometry grid;
  grid.size = { { n, n + 1, n + 2 } };
  grid.origin = { 100, -50, 7 };
  grid.spacing = { 0.5, 0.75, 2 };
  const double c = std::cos(0.4);
  const double s = std::sin(0.4);
  grid.direction = { { c, -s, 0, s, c, 0, 0, 0, -1 } };
  return grid;
}

} // namespace

TEST(Reassign, ABoxCoversCentresInIt)
{
  LabelImage image = Uniform(8, 1);
  const auto report = Edited(image, Plain({ Box({ 1.5, 1.5, 1.5 }, { 3.5, 4.5, 5.5 }, 7) }));
  ASSERT_TRUE(report);
  EXPECT_EQ(VoxelsOf(image, 7).size(), 2u * 3u * 4u);
  EXPECT_EQ(image.labels[static_cast<std::size_t>(image.grid.Index(2, 2, 2))], 7);
  EXPECT_EQ(report->edits[0].covered, 24);
  EXPECT_EQ(report->edits[0].changed, 24);
}

TEST(Reassign, ABoxThatEndsOnCentresHoldsThem)
{
  LabelImage image = Uniform(8, 1);
  image.grid.spacing = { 0.1, 0.1, 0.1 };
  // 3 * 0.1 is more than 0.3 in doubles.
  ASSERT_TRUE(Edited(image, Plain({ Box({ 0, 0, 0 }, { 0.3, 0.3, 0.3 }, 7) })));
  EXPECT_EQ(VoxelsOf(image, 7).size(), 64u);
}

TEST(Reassign, WorldCoordinatesHonourOriginSpacingAndDirection)
{
  for (const bool box : { true, false })
  {
    LabelImage image{ Turned(9), {} };
    image.labels.assign(static_cast<std::size_t>(image.grid.Count()), 1);
    const Vec3 middle = image.grid.ToWorld(4, 5, 5);
    const Vec3 half{ 1.1, 0.9, 4.2 };
    ASSERT_TRUE(Edited(image, Plain({ box ? Box(middle - half, middle + half, 3) : Ball(middle, 2.3, 3) })));
    Id found = 0;
    for (Id k = 0; k < image.grid.size[2]; ++k)
    {
      for (Id j = 0; j < image.grid.size[1]; ++j)
      {
        for (Id i = 0; i < image.grid.size[0]; ++i)
        {
          const Vec3 d =
            image.grid.ToWorld(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)) -
            middle;
          const bool inside =
            box ? std::abs(d.x) <= half.x && std::abs(d.y) <= half.y && std::abs(d.z) <= half.z
                : Norm(d) <= 2.3;
          ASSERT_EQ(image.labels[static_cast<std::size_t>(image.grid.Index(i, j, k))], inside ? 3 : 1)
            << i << ' ' << j << ' ' << k;
          found += inside ? 1 : 0;
        }
      }
    }
    EXPECT_GT(found, 20);
  }
}

TEST(Reassign, EditsAreAppliedInOrderAndRestricted)
{
  LabelImage image = Uniform(8, 1);
  VoxelEdit second = Box({ -1, -1, -1 }, { 9, 9, 3.5 }, 4);
  second.name = "edit 2";
  second.from = { 7 };
  const auto report = Edited(image, Plain({ Box({ 1.5, 1.5, 1.5 }, { 5.5, 5.5, 5.5 }, 7), second }));
  ASSERT_TRUE(report);
  EXPECT_EQ(VoxelsOf(image, 4).size(), 32u);
  EXPECT_EQ(VoxelsOf(image, 7).size(), 32u);
  EXPECT_EQ(report->edits[1].covered, 8 * 8 * 4);
  EXPECT_EQ(report->edits[1].decided, 32);
  EXPECT_EQ(report->edits[1].changed, 32);
  EXPECT_TRUE(report->warnings.empty());
}

TEST(Reassign, VoxelsCountOnce)
{
  LabelImage image = Uniform(4, 1);
  const auto report = Edited(image, Plain({ List({ 5, 63, 5, 0 }, 65535) }));
  ASSERT_TRUE(report);
  EXPECT_EQ(VoxelsOf(image, 65535), (std::vector<Id>{ 0, 5, 63 }));
  EXPECT_EQ(report->edits[0].covered, 3);
}

TEST(Reassign, EditsThatChangeNothingAreTold)
{
  LabelImage image = Uniform(4, 1);
  VoxelEdit restricted = List({ 1 }, 3);
  restricted.from = { 2 };
  const auto report =
    Edited(image, Plain({ List({ 1, 2 }, 1), restricted, Ball({ 50, 0, 0 }, 2, 3), List({}, 2) }));
  ASSERT_TRUE(report);
  ASSERT_EQ(report->warnings.size(), 4u);
  EXPECT_NE(report->warnings[0].find("its 2 voxels have this material already"), std::string::npos);
  EXPECT_NE(report->warnings[1].find("none of its 1 voxels has a material it is restricted to"),
            std::string::npos);
  EXPECT_NE(report->warnings[2].find("covers no voxel centre"), std::string::npos);
  EXPECT_NE(report->warnings[3].find("has no voxels"), std::string::npos);
}

TEST(Reassign, WrongEdits)
{
  ExpectFailure(Plain({ Box({ 2, 0, 0 }, { 1, 3, 3 }, 1) }), "the box is empty, along x it runs from 2 to 1");
  ExpectFailure(Plain({ Box({ 0, 0, 1 }, { 1, 3, 1 }, 1) }), "the box is empty, along z");
  ExpectFailure(Plain({ Box({ std::nan(""), 0, 1 }, { 1, 3, 2 }, 1) }), "not a finite number");
  ExpectFailure(Plain({ Ball({ 0, 0, 0 }, 0, 1) }), "the radius 0");
  ExpectFailure(Plain({ Ball({ 0, 0, 0 }, -1, 1) }), "the radius -1");
  ExpectFailure(Plain({ Ball({ 0, 0, 0 }, std::numeric_limits<double>::infinity(), 1) }), "the radius inf");
  ExpectFailure(Plain({ List({ 1 }, 65536) }), "the material to give is 65536");
  ExpectFailure(Plain({ List({ 1 }, -1) }), "the material to give is -1");
  ExpectFailure(Plain({ List({ 1, 64, -3, 99 }, 1) }),
                "3 of 4 voxel ids are outside the image (the first is 64)");
  VoxelEdit other = List({ 1 }, 1);
  other.size = { { 5, 4, 4 } };
  ExpectFailure(Plain({ other }), "an image of 5 x 4 x 4 voxels, this one has 4 x 4 x 4");
  VoxelEdit from = List({ 1 }, 1);
  from.from = { 70000 };
  ExpectFailure(Plain({ from }), "restricted to material 70000");
  ReassignOptions pair = Plain({ List({ 1 }, 1) });
  pair.forbidden = { { { 2, 2 } } };
  ExpectFailure(pair, "the forbidden contact of materials 2 and 2");
}

TEST(Reassign, TheFirstWrongEditLeavesTheImage)
{
  VoxelEdit wrong = List({ 64 }, 2);
  wrong.name = "edit 2";
  ExpectFailure(Plain({ List({ 1 }, 2), wrong }), "edit 2: 1 of 1");
}

TEST(Reassign, HugeShapesCoverAll)
{
  LabelImage image = Uniform(5, 1);
  ASSERT_TRUE(Edited(image, Plain({ Box({ -1e300, -1e300, -1e300 }, { 1e300, 1e300, 1e300 }, 2) })));
  EXPECT_EQ(VoxelsOf(image, 2).size(), 125u);
  ASSERT_TRUE(Edited(image, Plain({ Ball({ 0, 0, 0 }, 1e12, 3) })));
  EXPECT_EQ(VoxelsOf(image, 3).size(), 125u);
}

TEST(Reassign, WithoutEditsNothingIsRepaired)
{
  LabelImage image = images::Noise(8, 3, 5);
  const LabelImage before = image;
  const auto report = Edited(image, ReassignOptions());
  ASSERT_TRUE(report);
  EXPECT_FALSE(report->mended);
  EXPECT_EQ(image.labels, before.labels);
}

TEST(Reassign, TheRepairLeavesDecidedVoxels)
{
  // Two voxels that touch over an edge: faults unless a third joins them or one gives way.
  LabelImage image = Uniform(8, 0);
  std::vector<unsigned char> decisions;
  ReassignOptions options;
  options.edits = { List({ image.grid.Index(3, 3, 3), image.grid.Index(4, 4, 3) }, 1) };
  ThreadMonitor monitor;
  const auto report = Reassign(image, decisions, options, monitor);
  ASSERT_TRUE(report);
  EXPECT_TRUE(FindTopologyFaults(image, {}, monitor).empty());
  EXPECT_EQ(report->remaining, 0);
  EXPECT_EQ(report->overridden, 0);
  EXPECT_FALSE(report->repaired.empty());
  EXPECT_EQ(image.labels[static_cast<std::size_t>(image.grid.Index(3, 3, 3))], 1);
  EXPECT_EQ(image.labels[static_cast<std::size_t>(image.grid.Index(4, 4, 3))], 1);
  EXPECT_EQ(std::count(decisions.begin(), decisions.end(), Decided), 2);
}

TEST(Reassign, TheRepairOverridesOnlyWhereNothingElseHelps)
{
  // All voxels around the contact are decided: one of them has to give way.
  LabelImage image = Uniform(8, 0);
  const auto& grid = image.grid;
  std::vector<unsigned char> decisions;
  ReassignOptions options;
  options.edits = { Box({ -1, -1, -1 }, { 9, 9, 9 }, 0),
                    List({ grid.Index(3, 3, 3), grid.Index(4, 4, 3) }, 1) };
  ThreadMonitor monitor;
  const auto report = Reassign(image, decisions, options, monitor);
  ASSERT_TRUE(report);
  EXPECT_TRUE(FindTopologyFaults(image, {}, monitor).empty());
  EXPECT_GT(report->overridden, 0);
  EXPECT_LE(report->overridden, 2);
  EXPECT_EQ(std::count(decisions.begin(), decisions.end(), Overridden), report->overridden);
  EXPECT_EQ(static_cast<Id>(report->overriddenAt.size()), report->overridden);
  ASSERT_EQ(report->warnings.size(), 2u) << "the box of background, and the overridden voxels";
  EXPECT_NE(report->warnings[1].find("voxels that the edits had decided"), std::string::npos);
}

TEST(Reassign, ForbiddenContactsAreRepaired)
{
  // Blood set by hand onto the wall's outer side: background may not touch it.
  LabelImage image = images::Shell(20, 4, 7);
  ReassignOptions options;
  options.forbidden = { { { 0, 2 } } };
  options.edits = { Ball(image.grid.ToWorld(15, 9.5, 9.5), 1.5, 2) };
  const auto report = Edited(image, options);
  ASSERT_TRUE(report);
  EXPECT_GT(report->forbiddenContacts, 0);
  EXPECT_EQ(report->remaining, 0);
  EXPECT_EQ(report->overridden, 0) << "the wall is put around the decided voxels";
  const auto& size = image.grid.size;
  for (Id k = 1; k < size[2] - 1; ++k)
  {
    for (Id j = 1; j < size[1] - 1; ++j)
    {
      for (Id i = 1; i < size[0] - 1; ++i)
      {
        const int label = image.labels[static_cast<std::size_t>(image.grid.Index(i, j, k))];
        for (Id q = 0; label == 2 && q < 27; ++q)
        {
          const Id other = image.grid.Index(i - 1 + q % 3, j - 1 + q / 3 % 3, k - 1 + q / 9);
          ASSERT_NE(image.labels[static_cast<std::size_t>(other)], 0) << i << ' ' << j << ' ' << k;
        }
      }
    }
  }
}

TEST(Reassign, TheSameForAnyNumberOfThreads)
{
  const LabelImage input = images::Noise(12, 4, 11);
  ReassignOptions options;
  options.edits = { Ball({ 4, 5, 5 }, 3, 3), Box({ 2, 2, 2 }, { 6, 10, 5 }, 1) };
  options.edits[1].from = { 3, 0 };
  LabelImage one = input;
  const auto first = Edited(one, options, 1);
  ASSERT_TRUE(first);
  for (const int threads : { 2, 5 })
  {
    LabelImage many = input;
    const auto report = Edited(many, options, threads);
    ASSERT_TRUE(report);
    EXPECT_EQ(many.labels, one.labels);
    EXPECT_EQ(report->repaired, first->repaired);
    EXPECT_EQ(report->edits[0].covered, first->edits[0].covered);
  }
}

TEST(Reassign, StopsOnRequest)
{
  LabelImage image = Uniform(8, 0);
  const LabelImage before = image;
  ThreadMonitor monitor;
  monitor.Cancel();
  std::vector<unsigned char> decisions;
  const auto report = Reassign(image, decisions, Plain({ List({ 1 }, 1) }), monitor);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.GetError().kind, Failure::Cancelled);
  EXPECT_EQ(image.labels, before.labels);
}
