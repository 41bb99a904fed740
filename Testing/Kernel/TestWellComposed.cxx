// SPDX-License-Identifier: BSD-3-Clause
#include "Images.h"
#include "Mesh/WellComposed.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace lamina;

namespace
{

/// The voxels of the box from `low` to `high`, both included.
std::vector<Id> VoxelsOf(const GridGeometry& grid, const std::array<Id, 3>& low,
                         const std::array<Id, 3>& high)
{
  std::vector<Id> ids;
  for (Id k = low[2]; k <= high[2]; ++k)
  {
    for (Id j = low[1]; j <= high[1]; ++j)
    {
      for (Id i = low[0]; i <= high[0]; ++i)
      {
        ids.push_back(grid.Index(i, j, k));
      }
    }
  }
  return ids;
}

LabelImage Uniform(Id n, int label)
{
  return images::Make({ { n, n, n } }, [=](Id, Id, Id) { return label; });
}

int& At(LabelImage& image, Id i, Id j, Id k)
{
  return image.labels[static_cast<std::size_t>(image.grid.Index(i, j, k))];
}

/// Repairs the image; it must end clean, and every voxel that differs must have been told.
void ExpectRepaired(const LabelImage& before, const char* what)
{
  ThreadMonitor monitor;
  LabelImage after = before;
  const auto changed = RepairTopology(after, {}, monitor).changed;
  EXPECT_TRUE(FindTopologyFaults(after, {}, monitor).empty()) << what;
  EXPECT_TRUE(std::is_sorted(changed.begin(), changed.end())) << what;
  for (std::size_t v = 0; v < after.labels.size(); ++v)
  {
    if (after.labels[v] != before.labels[v])
    {
      ASSERT_TRUE(std::binary_search(changed.begin(), changed.end(), static_cast<Id>(v))) << what << ' ' << v;
    }
  }
  EXPECT_TRUE(RepairTopology(after, {}, monitor).changed.empty()) << what;
}

} // namespace

TEST(WellComposed, CriticalEdges)
{
  EXPECT_TRUE(IsCriticalEdge(1, 0, 1, 0));
  EXPECT_TRUE(IsCriticalEdge(1, 0, 1, 2));
  EXPECT_TRUE(IsCriticalEdge(1, 0, 2, 0));
  EXPECT_FALSE(IsCriticalEdge(1, 1, 1, 1));
  EXPECT_FALSE(IsCriticalEdge(1, 1, 0, 0));
  EXPECT_FALSE(IsCriticalEdge(1, 0, 0, 0));
  EXPECT_FALSE(IsCriticalEdge(1, 1, 1, 0));
  EXPECT_FALSE(IsCriticalEdge(1, 2, 3, 4));
  EXPECT_FALSE(IsCriticalEdge(1, 1, 2, 3));
}

TEST(WellComposed, EdgeContactIsFound)
{
  ThreadMonitor monitor;
  LabelImage image = Uniform(4, 0);
  At(image, 1, 1, 1) = 1;
  At(image, 2, 2, 1) = 1;
  // The edge between the lattice points (2, 2, 1) and (2, 2, 2): all voxels around both.
  EXPECT_EQ(FindTopologyFaults(image, {}, monitor), VoxelsOf(image.grid, { { 1, 1, 0 } }, { { 2, 2, 2 } }));
  At(image, 1, 2, 1) = 1;
  EXPECT_TRUE(FindTopologyFaults(image, {}, monitor).empty());
}

TEST(WellComposed, CornerContactIsFoundInAMaterialAndInItsComplement)
{
  ThreadMonitor monitor;
  for (const int inside : { 0, 1 })
  {
    LabelImage image = Uniform(4, inside);
    At(image, 1, 1, 1) = 1 - inside;
    At(image, 2, 2, 2) = 1 - inside;
    EXPECT_EQ(FindTopologyFaults(image, {}, monitor), VoxelsOf(image.grid, { { 1, 1, 1 } }, { { 2, 2, 2 } }))
      << inside;
  }
}

TEST(WellComposed, OutsideIsBackground)
{
  ThreadMonitor monitor;
  LabelImage image = Uniform(3, 1);
  At(image, 1, 0, 0) = 0; // a notch in the edge of the image is no contact
  EXPECT_TRUE(FindTopologyFaults(image, {}, monitor).empty());
  At(image, 1, 0, 0) = 1;
  At(image, 1, 1, 0) = 0; // touches the outside through its own face, clean too
  EXPECT_TRUE(FindTopologyFaults(image, {}, monitor).empty());
  At(image, 1, 1, 0) = 1;
  At(image, 1, 1, 1) = 0; // a cavity
  EXPECT_TRUE(FindTopologyFaults(image, {}, monitor).empty());
  At(image, 1, 1, 1) = 1;
  image = Uniform(3, 0);
  At(image, 0, 0, 0) = 1;
  At(image, 1, 1, 0) = 1; // meet in an edge that ends in the border
  EXPECT_EQ(FindTopologyFaults(image, {}, monitor), VoxelsOf(image.grid, { { 0, 0, 0 } }, { { 1, 1, 1 } }));
}

TEST(WellComposed, CleanImagesStay)
{
  ThreadMonitor monitor;
  for (const LabelImage& clean : { Uniform(4, 0), Uniform(4, 3), images::Shell(13, 3.2, 5.6) })
  {
    LabelImage image = clean;
    EXPECT_TRUE(RepairTopology(image, {}, monitor).changed.empty());
    EXPECT_EQ(image.labels, clean.labels);
  }
}

TEST(WellComposed, OneVoxelMendsOneContact)
{
  ThreadMonitor monitor;
  LabelImage image = Uniform(6, 0);
  for (Id v : VoxelsOf(image.grid, { { 1, 1, 1 } }, { { 2, 2, 4 } }))
  {
    image.labels[static_cast<std::size_t>(v)] = 1;
  }
  At(image, 3, 3, 2) = 1;
  const auto changed = RepairTopology(image, {}, monitor).changed;
  EXPECT_EQ(changed.size(), 1u);
  EXPECT_TRUE(FindTopologyFaults(image, {}, monitor).empty());
}

TEST(WellComposed, Checkerboards)
{
  for (const auto& labels : { std::array<int, 2>{ { 0, 1 } }, std::array<int, 2>{ { 2, 5 } } })
  {
    ExpectRepaired(images::Make({ { 6, 6, 6 } }, [&](Id i, Id j, Id k)
                                { return labels[static_cast<std::size_t>((i + j + k) % 2)]; }),
                   "fields");
    ExpectRepaired(images::Make({ { 6, 6, 6 } }, [&](Id i, Id j, Id)
                                { return labels[static_cast<std::size_t>((i + j) % 2)]; }),
                   "columns");
  }
}

TEST(WellComposed, NoiseEndsClean)
{
  for (unsigned seed = 0; seed < 24; ++seed)
  {
    const int labels = 2 + static_cast<int>(seed % 4);
    ExpectRepaired(images::Noise(8, labels, seed), std::to_string(seed).c_str());
  }
}

TEST(WellComposed, ThreadsMakeNoDifference)
{
  const LabelImage noise = images::Noise(12, 3, 7);
  ThreadMonitor one(1);
  ThreadMonitor three(3);
  LabelImage a = noise;
  LabelImage b = noise;
  EXPECT_EQ(FindTopologyFaults(noise, {}, one), FindTopologyFaults(noise, {}, three));
  EXPECT_EQ(RepairTopology(a, {}, one).changed, RepairTopology(b, {}, three).changed);
  EXPECT_EQ(a.labels, b.labels);
}
