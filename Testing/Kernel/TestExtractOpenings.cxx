// SPDX-License-Identifier: BSD-3-Clause
#include "Images.h"
#include "Mesh/Closedness.h"
#include "Mesh/VolumeCorrection.h"
#include "Surface/ExtractInterfaces.h"

#include <gtest/gtest.h>

#include <map>

using namespace lamina;

namespace
{

/// A tube along z from slice `low` to `high`: material 2 inside, with `wall` material 1 around it.
LabelImage Tube(Id slices, Id low, Id high, bool wall)
{
  return images::Make({ { 12, 12, slices } },
                      [=](Id i, Id j, Id k)
                      {
                        const double x = static_cast<double>(i) - 5.5;
                        const double y = static_cast<double>(j) - 5.5;
                        const double r = std::sqrt(x * x + y * y);
                        const bool along = k >= low && k <= high;
                        return !along ? 0 : (r < 2.6 ? 2 : (wall && r < 4.7 ? 1 : 0));
                      });
}

double SliceOf(const LabelImage& image, int material)
{
  const auto begin = image.labels.begin() + image.grid.Index(0, 0, image.grid.size[2] / 2);
  return static_cast<double>(std::count(begin, begin + image.grid.size[0] * image.grid.size[1], material));
}

struct Patch
{
  double area = 0;
  double low = 1e300;
  double high = -1e300;
  std::vector<int> materials;
};

/// Area, extent along z and first materials of every named patch.
std::map<std::string, Patch> PatchesOf(const TriangleComplex& surface)
{
  std::map<std::string, Patch> patches;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto p = static_cast<std::size_t>(surface.Patch(static_cast<Id>(t)));
    Patch& patch = patches[surface.patchNames.empty() ? "wall" : surface.patchNames[p]];
    patch.area += 0.5 * Norm(AreaVector2(surface.points, surface.triangles[t]));
    patch.materials.push_back(surface.materials[t].first);
    for (Id corner : surface.triangles[t])
    {
      patch.low = std::min(patch.low, surface.points[static_cast<std::size_t>(corner)].z);
      patch.high = std::max(patch.high, surface.points[static_cast<std::size_t>(corner)].z);
    }
  }
  return patches;
}

TriangleComplex Extract(const LabelImage& image, const ExtractInterfacesOptions& options, Id openings)
{
  ThreadMonitor monitor;
  TriangleComplex surface;
  const auto report = ExtractInterfaces(image, surface, options, monitor);
  EXPECT_TRUE(report);
  EXPECT_EQ(report->openings, openings);
  const auto error = CheckClosed(surface, true, monitor);
  EXPECT_FALSE(error) << error->message;
  return surface;
}

void ExpectOpening(const TriangleComplex& surface, const std::string& name, double z, double area)
{
  const auto patches = PatchesOf(surface);
  ASSERT_EQ(patches.count(name), 1u) << name;
  const Patch& patch = patches.at(name);
  EXPECT_EQ(patch.low, z) << name;
  EXPECT_EQ(patch.high, z) << name;
  EXPECT_EQ(patch.area, area) << name;
  EXPECT_EQ(std::count(patch.materials.begin(), patch.materials.end(), 2),
            static_cast<std::ptrdiff_t>(patch.materials.size()))
    << name;
}

} // namespace

TEST(ExtractOpenings, AtTheImageBorder)
{
  const LabelImage image = Tube(9, 0, 8, true);
  ExtractInterfacesOptions options;
  options.openMaterials = { 2 };
  options.openAtImageBorder = true;
  const TriangleComplex surface = Extract(image, options, 2);
  ASSERT_GE(surface.patchNames.size(), 3u);
  EXPECT_EQ(surface.patchNames[0], "wall");
  EXPECT_EQ(surface.patchNames[1], "opening_1");
  EXPECT_EQ(surface.patchNames[2], "opening_2");
  ExpectOpening(surface, "opening_1", -0.5, SliceOf(image, 2));
  ExpectOpening(surface, "opening_2", 8.5, SliceOf(image, 2));
  // The wall's own ends are plane borders, not openings.
  EXPECT_EQ(surface.patchNames.size(), 5u);
  EXPECT_FALSE(IsOpening(surface, 0));
  EXPECT_TRUE(IsOpening(surface, 1));
  EXPECT_FALSE(IsOpening(surface, 3));
  EXPECT_EQ(PatchesOf(surface).at(surface.patchNames[3]).area, SliceOf(image, 1));
}

TEST(ExtractOpenings, WithoutTheOptionEndsArePlaneBorders)
{
  const LabelImage image = Tube(9, 0, 8, true);
  const TriangleComplex surface = Extract(image, {}, 0);
  for (const auto& patch : PatchesOf(surface))
  {
    EXPECT_EQ(patch.first.rfind("opening", 0), std::string::npos) << patch.first;
    if (patch.first != "wall")
    {
      EXPECT_EQ(patch.second.area, SliceOf(image, 1) + SliceOf(image, 2));
      EXPECT_EQ(patch.second.low, patch.second.high);
    }
  }
}

TEST(ExtractOpenings, NothingReachesTheBorder)
{
  ExtractInterfacesOptions options;
  options.openMaterials = { 2 };
  options.openAtImageBorder = true;
  const TriangleComplex surface = Extract(Tube(9, 1, 7, true), options, 0);
  EXPECT_TRUE(surface.patches.empty());
}

TEST(ExtractOpenings, AtTheMasksEdge)
{
  const LabelImage image = Tube(16, 2, 13, false);
  const LabelImage mask =
    images::Make(image.grid.size, [](Id, Id, Id k) { return k >= 2 && k <= 13 ? 1 : 0; });
  ExtractInterfacesOptions options;
  options.openMaterials = { 2 };
  options.openAtMaskBorder = true;
  options.mask = &mask;
  const TriangleComplex surface = Extract(image, options, 2);
  // One slice at each end is given up for a plane that lies inside the mask.
  ExpectOpening(surface, "opening_1", 2.5, SliceOf(image, 2));
  ExpectOpening(surface, "opening_2", 12.5, SliceOf(image, 2));
  EXPECT_EQ(MaterialVolumes(surface, { 2 })[0], 10 * SliceOf(image, 2));
}

TEST(ExtractOpenings, AnObliqueMaskIsCutPlane)
{
  // The mask's edge climbs by one voxel across the tube.
  LabelImage image = Tube(20, 0, 19, false);
  const LabelImage mask =
    images::Make(image.grid.size, [](Id i, Id, Id k) { return k >= 2 + (i > 5 ? 1 : 0) && k <= 16 ? 1 : 0; });
  for (std::size_t v = 0; v < image.labels.size(); ++v)
  {
    image.labels[v] *= mask.labels[v];
  }
  ExtractInterfacesOptions options;
  options.openMaterials = { 2 };
  options.openAtMaskBorder = true;
  options.mask = &mask;
  const TriangleComplex surface = Extract(image, options, 2);
  ExpectOpening(surface, "opening_1", 3.5, SliceOf(image, 2));
  ExpectOpening(surface, "opening_2", 15.5, SliceOf(image, 2));
}

TEST(ExtractOpenings, ACutMustNotTakeMuch)
{
  const LabelImage image = Tube(9, 3, 5, false);
  const LabelImage mask =
    images::Make(image.grid.size, [](Id, Id, Id k) { return k >= 3 && k <= 5 ? 1 : 0; });
  ExtractInterfacesOptions options;
  options.openMaterials = { 2 };
  options.openAtMaskBorder = true;
  options.mask = &mask;
  const TriangleComplex surface = Extract(image, options, 0);
  EXPECT_EQ(MaterialVolumes(surface, { 2 })[0], images::CountOf(image, 2));
}
