// SPDX-License-Identifier: BSD-3-Clause
// What a repair may change and what it must keep; the search against trying everything.
#include "Images.h"
#include "Mesh/LabelLattice.h"
#include "Mesh/WellComposed.h"
#include "Segmentation/ConnectedComponents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <set>

using namespace lamina;

namespace
{

int& At(LabelImage& image, Id i, Id j, Id k)
{
  return image.labels[static_cast<std::size_t>(image.grid.Index(i, j, k))];
}

Id Pieces(const LabelImage& image, int label)
{
  ThreadMonitor monitor;
  return FindComponents(image.labels, image.grid.size, Connectivity::Faces, monitor).CountOf(label);
}

RepairReport Repair(LabelImage& image, const RepairOptions& options = {})
{
  ThreadMonitor monitor;
  return RepairTopology(image, options, monitor);
}

bool IsClean(const LabelImage& image, const RepairOptions& options = {})
{
  ThreadMonitor monitor;
  return FindTopologyFaults(image, options, monitor).empty();
}

/// White noise, or the greatest of `materials` noises blurred with a standard deviation of two voxels.
LabelImage RandomImage(Id n, int materials, bool blurred, unsigned seed)
{
  std::mt19937 random(seed);
  LabelImage image = images::Make({ { n, n, n } }, [&](Id, Id, Id)
                                  { return static_cast<int>(random() % static_cast<unsigned>(materials)); });
  if (!blurred)
  {
    return image;
  }
  std::vector<double> greatest(image.labels.size(), -1e30);
  for (int m = 0; m < materials; ++m)
  {
    std::vector<double> field(image.labels.size());
    std::generate(field.begin(), field.end(), [&]() { return static_cast<double>(random() % 10000) - 5000; });
    for (const Id step : { Id(1), n, n * n })
    {
      std::vector<double> smooth(field.size(), 0);
      for (Id v = 0; v < image.grid.Count(); ++v)
      {
        const Id at = v / step % n;
        for (Id t = std::max<Id>(-at, -6); t <= std::min<Id>(6, n - 1 - at); ++t)
        {
          smooth[static_cast<std::size_t>(v)] +=
            std::exp(-static_cast<double>(t * t) / 8) * field[static_cast<std::size_t>(v + t * step)];
        }
      }
      field = smooth;
    }
    for (std::size_t v = 0; v < field.size(); ++v)
    {
      image.labels[v] = field[v] > greatest[v] ? m : image.labels[v];
      greatest[v] = std::max(greatest[v], field[v]);
    }
  }
  return image;
}

/// The least number of changes that mend an image, by trying every set of one, two, ... changes in which each
/// touches a faulty block. -1 if more than `most` steps are needed.
class Exhaustive
{
public:
  Exhaustive(const LabelImage& image, Id most)
    : Image(image)
    , Lattice(this->Image, RepairOptions())
    , Left(most)
  {
  }
  int Find()
  {
    for (int changes = 0;; ++changes)
    {
      if (this->Try(changes) || this->Left <= 0)
      {
        return this->Left > 0 ? changes : -1;
      }
    }
  }

private:
  std::vector<LabelLattice::Place> Faulty() const
  {
    std::vector<LabelLattice::Place> faulty;
    for (Id p = 0; p < this->Lattice.PointCount(); ++p)
    {
      const auto place = this->Lattice.PointPlace(p);
      if (this->Lattice.FaultsAt(place).All() > 0)
      {
        faulty.push_back(place);
      }
    }
    return faulty;
  }
  bool Try(int changes)
  {
    const auto faulty = this->Faulty();
    if (faulty.empty())
    {
      return true;
    }
    if (changes == 0 || --this->Left <= 0)
    {
      return false;
    }
    const Block block = this->Lattice.BlockAt(faulty.front());
    for (int q = 0; q < 8; ++q)
    {
      const auto voxel = LabelLattice::VoxelAround(faulty.front(), q);
      for (const int label : std::set<int>(block.labels.begin(), block.labels.end()))
      {
        const int own = this->Lattice.Label(voxel);
        if (!this->Lattice.IsVoxel(voxel) || label == own)
        {
          continue;
        }
        At(this->Image, voxel[0], voxel[1], voxel[2]) = label;
        const bool found = this->Try(changes - 1);
        At(this->Image, voxel[0], voxel[1], voxel[2]) = own;
        if (found)
        {
          return true;
        }
      }
    }
    return false;
  }

  LabelImage Image;
  LabelLattice Lattice;
  Id Left;
};

/// How `count` images of 4x4x4 voxels fare against trying every set of changes, within `steps` of that
/// search.
void CompareWithTryingEverything(unsigned count, Id steps)
{
  int solved = 0;
  int above = 0;
  Id ours = 0;
  Id least = 0;
  for (unsigned seed = 0; seed < count; ++seed)
  {
    const int materials = 2 + static_cast<int>(seed % 3);
    LabelImage image = RandomImage(4, materials, false, seed);
    if (seed % 2)
    {
      // Half of the images sparse, so that single contacts are met as well.
      for (std::size_t v = 0; v < image.labels.size(); v += 1 + v % 2)
      {
        image.labels[v] = 0;
      }
    }
    const int optimum = Exhaustive(image, steps).Find();
    const Id changed = static_cast<Id>(Repair(image).changed.size());
    EXPECT_TRUE(IsClean(image)) << seed;
    if (optimum >= 0)
    {
      ++solved;
      ours += changed;
      least += optimum;
      // A chorda of two voxels is thickened by three rather than deleted by one.
      EXPECT_LE(2 * changed, 3 * optimum + 3) << seed;
      above += 2 * changed > 3 * optimum + 1 ? 1 : 0;
    }
  }
  std::cout << count << " images of 4x4x4, " << solved << " of them solved: " << ours << " changes, " << least
            << " at least; more than half as many again in " << above << "\n";
  EXPECT_GE(3 * solved, static_cast<int>(count));
  EXPECT_LE(10 * ours, 11 * least);
  EXPECT_LE(20 * above, solved);
}

/// Repair `count` images of 16x16x16 voxels, of 2 to 6 materials, every second blurred.
void RepairRandomImages(unsigned count)
{
  double slowest = 0;
  std::array<double, 2> shares{ { 0, 0 } };
  for (unsigned seed = 0; seed < count; ++seed)
  {
    const bool blurred = seed % 2 == 1;
    LabelImage image = RandomImage(16, 2 + static_cast<int>(seed / 2 % 5), blurred, seed);
    std::map<int, int> before;
    for (const int label : image.labels)
    {
      ++before[label];
    }
    const auto start = std::chrono::steady_clock::now();
    const auto changed = Repair(image).changed.size();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    slowest = std::max(slowest, seconds.count());
    shares[blurred] += static_cast<double>(changed) / static_cast<double>(image.labels.size());
    EXPECT_TRUE(IsClean(image)) << seed;
    EXPECT_TRUE(!blurred || changed <= image.labels.size() / 20) << seed;
    for (const auto& item : before)
    {
      const bool there =
        std::find(image.labels.begin(), image.labels.end(), item.first) != image.labels.end();
      EXPECT_TRUE(there || item.second < 100) << seed << ' ' << item.first;
    }
  }
  std::cout << count << " images of 16x16x16: of noise " << 200 * shares[0] / count
            << " % changed, of blurred noise " << 200 * shares[1] / count << " %, the slowest took "
            << slowest << " s\n";
}

} // namespace

TEST(RepairTopology, VesselThatStepsDiagonallyIsThickenedNotCut)
{
  // Blood, one voxel thick, climbing one voxel along j and k with each along i: corner contacts all the way.
  LabelImage image = images::Make({ { 16, 16, 16 } }, [](Id i, Id j, Id k)
                                  { return i == j && j == k && i > 1 && i < 14 ? 2 : 1; });
  EXPECT_EQ(Pieces(image, 2), 12);
  const auto before = std::count(image.labels.begin(), image.labels.end(), 2);
  const RepairReport report = Repair(image);
  EXPECT_TRUE(IsClean(image));
  EXPECT_EQ(report.criticalCorners, 11);
  EXPECT_EQ(Pieces(image, 2), 1);
  EXPECT_GE(std::count(image.labels.begin(), image.labels.end(), 2), before);
  EXPECT_EQ(At(image, 2, 2, 2), 2);
  EXPECT_EQ(At(image, 13, 13, 13), 2);
}

TEST(RepairTopology, LeafletOfOneVoxelKeepsItsTwoSidesApart)
{
  LabelImage image = images::Make({ { 16, 16, 16 } },
                                  [](Id i, Id j, Id k)
                                  {
                                    const bool blood = i > 1 && i < 14 && j > 1 && j < 14 && k > 1 && k < 14;
                                    return blood && i + j != 15 ? 2 : 1;
                                  });
  EXPECT_EQ(Pieces(image, 2), 2);
  Repair(image);
  EXPECT_TRUE(IsClean(image));
  EXPECT_EQ(Pieces(image, 2), 2);
  EXPECT_EQ(Pieces(image, 1), 1);
  for (Id i = 2; i < 14; ++i)
  {
    EXPECT_EQ(At(image, i, 15 - i, 7), 1) << i;
  }
}

TEST(RepairTopology, ForbiddenNeighboursArePartedAndOpenBordersExempt)
{
  const auto vessel = [](Id, Id j, Id k)
  { return j > 2 && j < 8 && k > 2 && k < 8 ? 2 : (j > 1 && j < 9 && k > 1 && k < 9 ? 1 : 0); };
  const LabelImage open = images::Make({ { 11, 11, 11 } }, vessel); // ends at the border on both sides
  RepairOptions options;
  options.forbidden = { { 0, 2 } };
  options.openAtImageBorder = true;
  LabelImage image = open;
  EXPECT_TRUE(Repair(image, options).changed.empty());
  options.openAtImageBorder = false;
  EXPECT_GT(Repair(image, options).forbiddenContacts, 0);
  EXPECT_TRUE(IsClean(image, options));
  EXPECT_EQ(At(image, 5, 5, 5), 2);
  EXPECT_NE(At(image, 0, 5, 5), 2);
}

TEST(RepairTopology, FrozenVoxelsStayAndWhatTheyPreventIsCounted)
{
  LabelImage image = images::Make({ { 6, 6, 6 } }, [](Id, Id, Id) { return 0; });
  At(image, 2, 2, 2) = At(image, 3, 3, 2) = 1;
  std::vector<unsigned char> frozen(image.labels.size(), 0);
  RepairOptions options;
  options.frozen = &frozen;
  frozen[static_cast<std::size_t>(image.grid.Index(2, 2, 2))] = 1;
  frozen[static_cast<std::size_t>(image.grid.Index(3, 3, 2))] = 1;
  LabelImage some = image;
  EXPECT_EQ(Repair(some, options).remaining, 0);
  EXPECT_TRUE(IsClean(some));
  EXPECT_EQ(At(some, 2, 2, 2), 1);
  EXPECT_EQ(At(some, 3, 3, 2), 1);
  std::fill(frozen.begin(), frozen.end(), static_cast<unsigned char>(1));
  LabelImage all = image;
  const RepairReport report = Repair(all, options);
  EXPECT_EQ(report.remaining, 2); // both ends of the critical edge
  EXPECT_EQ(report.criticalEdges, 1);
  EXPECT_TRUE(report.changed.empty());
  EXPECT_EQ(all.labels, image.labels);
}

TEST(RepairTopology, NeedsAtMostHalfMoreChangesThanTryingEverything)
{
  CompareWithTryingEverything(60, 4000);
}

TEST(LongRepairTopology, NeedsAtMostHalfMoreChangesThanTryingEverything)
{
  CompareWithTryingEverything(200, 20000);
}

TEST(RepairTopology, RandomImagesChangeLittleAndNoMaterialVanishes)
{
  RepairRandomImages(30);
}

TEST(LongRepairTopology, RandomImagesChangeLittleAndNoMaterialVanishes)
{
  RepairRandomImages(1000);
}

TEST(RepairTopology, ForbiddenPairsInNoiseEndClean)
{
  RepairOptions options;
  options.forbidden = { { 0, 2 }, { 1, 3 } };
  for (const bool blurred : { false, true })
  {
    LabelImage image = RandomImage(12, 4, blurred, 5);
    EXPECT_EQ(Repair(image, options).remaining, 0);
    EXPECT_TRUE(IsClean(image, options));
  }
}

TEST(RepairTopology, NoiseOfManyPartsEndsCleanAndCostsLikeASmallOne)
{
  LabelImage small = RandomImage(16, 3, false, 2);
  LabelImage large = RandomImage(40, 3, false, 2); // several parts
  const auto share = [](const LabelImage& image, const RepairReport& report)
  { return static_cast<double>(report.changed.size()) / static_cast<double>(image.labels.size()); };
  const double first = share(small, Repair(small));
  const double second = share(large, Repair(large));
  EXPECT_TRUE(IsClean(large));
  EXPECT_LE(first, 0.26);
  EXPECT_LE(second, 1.15 * first); // less of it lies at the border, where background is certain
}

namespace
{

/// Asks to stop when it was asked for the n-th time, and counts what comes after.
class StoppingMonitor : public ThreadMonitor
{
public:
  explicit StoppingMonitor(Id after)
    : After(after)
  {
  }
  bool Cancelled() override { return ++this->Asked > this->After; }
  void Progress(double fraction, const char*) override
  {
    this->Rises = this->Rises && fraction >= this->Last && fraction <= 1;
    this->Last = fraction;
    this->Told += this->Asked > this->After ? 0 : 1;
  }
  Id Asked = 0;
  Id Told = 0;
  bool Rises = true;

private:
  Id After;
  double Last = 0;
};

} // namespace

TEST(RepairTopology, StopsSoonAndTellsOfItsProgress)
{
  const LabelImage noise = RandomImage(40, 3, false, 2);
  StoppingMonitor all(1000000000);
  LabelImage image = noise;
  RepairTopology(image, {}, all);
  EXPECT_TRUE(all.Rises);
  EXPECT_GT(all.Told, 5);
  EXPECT_GT(all.Asked, 10000);
  for (const Id after : { Id(0), Id(10), all.Asked / 2, all.Asked - all.Asked / 50 })
  {
    StoppingMonitor stopping(after);
    image = noise;
    RepairTopology(image, {}, stopping);
    EXPECT_LT(stopping.Asked, after + 100) << after;
  }
}
