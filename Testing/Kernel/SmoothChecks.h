// SPDX-License-Identifier: BSD-3-Clause
// What smoothing guarantees for every image, measured and expected.
#pragma once

#include "Images.h"
#include "Mesh/Adjacency.h"
#include "Mesh/VolumeCorrection.h"
#include "Search/SelfIntersection.h"
#include "Surface/ExtractInterfaces.h"
#include "Surface/SmoothSurface.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lamina::checks
{

/// Labels by the highest of as many random fields, each averaged over neighbours so many times; 0: noise.
inline LabelImage RandomLabels(Id n, int labels, unsigned seed, int blurs)
{
  std::mt19937 random(seed);
  const std::size_t count = static_cast<std::size_t>(n * n * n);
  std::vector<std::vector<double>> fields(static_cast<std::size_t>(labels), std::vector<double>(count));
  for (auto& field : fields)
  {
    for (double& value : field)
    {
      value = random() / 4294967296.0;
    }
    for (int pass = 0; pass < 3 * blurs; ++pass)
    {
      const auto before = field;
      const Id step = pass % 3 == 0 ? 1 : (pass % 3 == 1 ? n : n * n);
      for (Id i = 0; i < n * n * n; ++i)
      {
        const Id at = i / step % n;
        const auto value = [&](Id j) { return before[static_cast<std::size_t>(j)]; };
        field[static_cast<std::size_t>(i)] =
          (2 * value(i) + value(at > 0 ? i - step : i) + value(at < n - 1 ? i + step : i)) / 4;
      }
    }
  }
  return images::Make({ { n, n, n } },
                      [&](Id i, Id j, Id k)
                      {
                        const std::size_t at = static_cast<std::size_t>(i + n * (j + n * k));
                        std::size_t best = 0;
                        for (std::size_t l = 1; l < fields.size(); ++l)
                        {
                          best = fields[l][at] > fields[best][at] ? l : best;
                        }
                        return static_cast<int>(best);
                      });
}

/// Smooths the image's surface with `sweeps` and expects every guarantee.
inline void ExpectGuarantees(const LabelImage& image, const TriangleComplex& start, int sweeps,
                             const std::string& what)
{
  ThreadMonitor monitor(2);
  TriangleComplex surface = start;
  SmoothSurfaceOptions options;
  options.sweeps = sweeps;
  const auto report = SmoothSurface(surface, options, monitor);
  ASSERT_TRUE(report) << what << ": " << report.GetError().message;
  EXPECT_TRUE(FindIntersections(surface.points, surface.triangles, monitor).empty()) << what;
  EXPECT_EQ(report->certificate.intersectingPairs, 0) << what;
  EXPECT_GE(report->certificate.leastClearance, (1 - 1e-6) * 0.25) << what;
  EXPECT_GE(report->certificate.leastAngle, 10) << what;
  EXPECT_LE(report->largestPieceError, 1e-12) << what << ": " << report->missedPieces.size() << " missed";
  // A flipped triangle would lie back on its neighbours: the angles tell.
  for (const Triangle& t : surface.triangles)
  {
    EXPECT_GT(Norm2(AreaVector2(surface.points, t)), 0) << what;
  }
  // The drift caps, in mean edge lengths of the voxel faces.
  const double unit = MeanEdgeLength(start);
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    ASSERT_LE(Norm(surface.points[p] - start.points[p]), (1 + 1e-9) * 1.5 * unit) << what;
  }
  // What is held is the image's: its voxels, but for pieces that the repair removed whole.
  double held = 0;
  double voxels = 0;
  for (std::size_t m = 0; m < report->materials.size(); ++m)
  {
    held += report->volumesHeld[m];
    voxels += images::CountOf(image, report->materials[m]);
    EXPECT_LE(report->volumesHeld[m], images::CountOf(image, report->materials[m]) + 1e-6) << what;
  }
  EXPECT_LE(held, voxels + 1e-6) << what;
}

} // namespace lamina::checks
