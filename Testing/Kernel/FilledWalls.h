// SPDX-License-Identifier: BSD-3-Clause
// Surfaces filled with tets, and the depth of their walls.
#pragma once

#include "Volume/CoreTets.h"
#include "Volume/WallDepth.h"

#include <gtest/gtest.h>

namespace lamina::walls
{

struct Meshed
{
  VolumeMesh mesh;
  MeshPatches patches;
};

/// Fills all materials of the surface with tets no longer than `edge`.
inline Meshed Fill(const TriangleComplex& surface, double edge)
{
  ThreadMonitor monitor(2);
  Meshed meshed;
  CoreTetsOptions options;
  options.maximumEdge = edge;
  options.sizeFactor = 1;
  const auto report = MeshCoreTets(surface, {}, options, meshed.mesh, monitor);
  EXPECT_TRUE(report) << (report ? "" : report.GetError().message);
  EXPECT_TRUE(FindPatches(meshed.mesh, nullptr, {}, meshed.patches, monitor));
  return meshed;
}

struct Measured
{
  WallDepthField field;
  WallDepthReport report;
};

inline Measured Measure(const Meshed& meshed, const WallDepthOptions& options, int threads = 2)
{
  ThreadMonitor monitor(threads);
  Measured measured;
  const auto report = ComputeWallDepth(meshed.mesh, meshed.patches, options, measured.field, monitor);
  EXPECT_TRUE(report) << (report ? "" : report.GetError().message);
  measured.report = report ? *report : WallDepthReport{};
  return measured;
}

} // namespace lamina::walls
