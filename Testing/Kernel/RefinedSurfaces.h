// SPDX-License-Identifier: BSD-3-Clause
// From labels to the surface that volumes are meshed in, by the defaults of all stages.
#pragma once

#include "Sizing/FeatureSize.h"
#include "Surface/ExtractInterfaces.h"
#include "Surface/RefineSurface.h"
#include "Surface/SmoothSurface.h"

#include <gtest/gtest.h>

namespace lamina
{

inline TriangleComplex RefinedSurface(const LabelImage& image, const FeatureSizeOptions& sizing = {})
{
  ThreadMonitor monitor(2);
  TriangleComplex surface;
  EXPECT_TRUE(ExtractInterfaces(image, surface, {}, monitor));
  EXPECT_TRUE(SmoothSurface(surface, {}, monitor));
  EXPECT_TRUE(ComputeFeatureSize(surface, sizing, monitor));
  EXPECT_TRUE(RefineSurface(surface, {}, monitor));
  return surface;
}

} // namespace lamina
