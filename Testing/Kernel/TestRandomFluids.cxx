// SPDX-License-Identifier: BSD-3-Clause
// Prisms and core in images that nobody drew: smoothed noise, every material taken for a fluid.
#include "CoreChecks.h"
#include "Images.h"
#include "Mesh/Audit.h"
#include "Mesh/VolumeCorrection.h"
#include "PrismChecks.h"
#include "RefinedSurfaces.h"
#include "Volume/AssembleMesh.h"
#include "Volume/CoreTets.h"

#include <map>
#include <random>

using namespace lamina;
using namespace prisms;

namespace
{

/// Each voxel the material of the highest of some fields of smoothed noise, the outermost layer background.
LabelImage Noise(unsigned seed, unsigned largest)
{
  std::mt19937 random(seed);
  const auto pick = [&](unsigned low, unsigned high) { return low + random() % (high - low + 1); };
  const Id n = static_cast<Id>(pick(16, largest));
  const int materials = static_cast<int>(pick(2, 4));
  const unsigned smoothings = pick(2, 6);
  const auto at = [&](Id i, Id j, Id k) { return static_cast<std::size_t>((k * n + j) * n + i); };
  std::vector<std::vector<double>> fields;
  for (int m = 0; m <= materials; ++m)
  {
    std::vector<double> field(at(0, 0, n));
    for (double& value : field)
    {
      value = static_cast<double>(random() % 65536) / 65536;
    }
    for (unsigned pass = 0; pass < smoothings; ++pass)
    {
      const std::vector<double> before = field;
      for (Id k = 0; k < n; ++k)
      {
        for (Id j = 0; j < n; ++j)
        {
          for (Id i = 0; i < n; ++i)
          {
            const auto near = [&](Id a) { return std::clamp(a, Id{ 0 }, n - 1); };
            field[at(i, j, k)] = 0.25 * before[at(i, j, k)] +
                                 0.125 * (before[at(near(i - 1), j, k)] + before[at(near(i + 1), j, k)] +
                                          before[at(i, near(j - 1), k)] + before[at(i, near(j + 1), k)] +
                                          before[at(i, j, near(k - 1))] + before[at(i, j, near(k + 1))]);
          }
        }
      }
    }
    fields.push_back(std::move(field));
  }
  return images::Make({ { n, n, n } },
                      [&](Id i, Id j, Id k)
                      {
                        if (std::min({ i, j, k, n - 1 - i, n - 1 - j, n - 1 - k }) == 0)
                        {
                          return 0;
                        }
                        int highest = 0;
                        for (int m = 1; m <= materials; ++m)
                        {
                          const auto value = [&](int f)
                          { return fields[static_cast<std::size_t>(f)][at(i, j, k)]; };
                          highest = value(m) > value(highest) ? m : highest;
                        }
                        return highest;
                      });
}

/// Each side of a wall's triangle has a first prism, or the triangle tells that layers are missing.
void ExpectFlagsTellAll(const TriangleComplex& surface, const Layers& layers, int asked)
{
  std::map<std::array<Id, 3>, std::size_t> triangleOf;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    Triangle key = surface.triangles[t];
    std::sort(key.begin(), key.end());
    triangleOf[key] = t;
  }
  std::map<std::size_t, int> firstPrisms;
  for (Id c = 0; c < layers.mesh.CellCount(); ++c)
  {
    if (layers.mesh.types[static_cast<std::size_t>(c)] != CellType::Wedge ||
        layers.mesh.layers[static_cast<std::size_t>(c)] != 1)
    {
      continue;
    }
    Triangle key;
    for (int k = 0; k < 3; ++k)
    {
      key[static_cast<std::size_t>(k)] =
        layers.mesh.interfaceNodeIds[static_cast<std::size_t>(layers.mesh.Cell(c)[k])];
    }
    std::sort(key.begin(), key.end());
    const auto found = triangleOf.find(key);
    ASSERT_NE(found, triangleOf.end());
    ++firstPrisms[found->second];
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const MaterialPair& pair = surface.materials[t];
    const int sides = (pair.first != 0 ? 1 : 0) + (pair.second != 0 ? 1 : 0);
    const int first = firstPrisms.count(t) > 0 ? firstPrisms.at(t) : 0;
    const int achieved = layers.onSurface.achieved[t];
    EXPECT_LE(first, sides);
    EXPECT_TRUE(first == sides || achieved < asked) << "a triangle without a prism and without a flag";
    EXPECT_GE(achieved, 0);
  }
}

void ExpectGoodFluids(unsigned seed, unsigned largest)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  const LabelImage image = Noise(seed, largest);
  ThreadMonitor monitor(2);
  const TriangleComplex surface = RefinedSurface(image);
  PrismLayersOptions options;
  options.materials = MaterialsOf(surface);
  options.layers = 2 + static_cast<int>(seed % 4);
  options.growth = 1 + 0.25 * static_cast<double>(seed % 3);
  const Layers layers = Grow(surface, options);
  ExpectFlagsTellAll(surface, layers, options.layers);
  VolumeMesh core;
  CoreTetsOptions filling;
  filling.isThorough = true;
  const auto filled = MeshCoreTets(layers.front, {}, filling, core, monitor);
  ASSERT_TRUE(filled) << filled.GetError().message;
  EXPECT_EQ(filled->rung, 1);
  EXPECT_GT(filled->leastQuality, 0.1);
  cores::ExpectFacesWithinLimits(layers.front, core);
  std::fill(core.interfaceNodeIds.begin(), core.interfaceNodeIds.end(), -1);
  for (Id c = 0; c < layers.mesh.CellCount(); ++c)
  {
    EXPECT_GT(CellVolume(layers.mesh, c), 0);
  }
  VolumeMesh mesh;
  ASSERT_TRUE(AssembleMesh({ &layers.mesh, &core }, {}, mesh, monitor));
  AuditMarks marks;
  const auto audit = AuditMesh(mesh, &surface, {}, marks, monitor);
  ASSERT_TRUE(audit) << audit.GetError().message;
  EXPECT_EQ(audit->invertedCells, 0);
  EXPECT_EQ(audit->overlaps, 0);
  EXPECT_EQ(audit->interfaceMismatches, 0);
  EXPECT_LT(audit->largestVolumeError, 1e-9);
}

class RandomFluids : public testing::TestWithParam<unsigned>
{
};

} // namespace

TEST(SmallRandomFluids, AreMeshed)
{
  ExpectGoodFluids(6, 16);
}

TEST_P(RandomFluids, AreMeshed)
{
  ExpectGoodFluids(GetParam(), 28);
}
INSTANTIATE_TEST_SUITE_P(LongRandom, RandomFluids, testing::Range(1u, 31u));
