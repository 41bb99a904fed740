// SPDX-License-Identifier: BSD-3-Clause
// The options of the feature size, checked and worked out for each material.
#pragma once

#include "FeatureSize.h"

#include <optional>

namespace lamina
{

/// What holds for one material.
struct SizeLimits
{
  int material = 0;
  int layers = 1;
  double anisotropy = 1;
  double minimum = 0;
  double maximum = 0;

  /// Edge length over feature size.
  double Ratio() const { return this->anisotropy / this->layers; }
};

/// Any option out of its range, whatever the surface.
std::optional<Error> CheckOptions(const FeatureSizeOptions& options);

/// One entry for each of `report.materials`; fills the report's limits.
Result<std::vector<SizeLimits>> FindLimits(const TriangleComplex& surface, const FeatureSizeOptions& options,
                                           FeatureSizeReport& report);

} // namespace lamina
