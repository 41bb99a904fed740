// SPDX-License-Identifier: BSD-3-Clause
// The curvature of a quadric fitted to a piece of a sheet.
#pragma once

#include "SheetStencil.h"

#include <algorithm>

namespace lamina
{

/// Principal curvatures, positive where the surface bends away from its normal.
struct PointCurvature
{
  double maximum = 0;
  double minimum = 0;
  Vec3 direction; ///< of the maximum, unit; zero if there was nothing to fit to

  double Strongest() const { return std::max(std::abs(this->maximum), std::abs(this->minimum)); }
};

/// A point of the neighbourhood, in units of the reach from the point that is fitted.
struct QuadricSample
{
  Vec3 place;
  Vec3 normal;
  double taper = 0;
  double trust = 1; ///< falls where the point lies far off a fit
  double x = 0;     ///< in the frame of the fit
  double y = 0;
  double height = 0;
  double weight = 0;
};

/// Memory that fits of one thread share.
struct QuadricScratch
{
  std::vector<QuadricSample> samples;
  std::vector<double> residuals;
};

/// The curvature at `centre` of the quadric that fits the points gathered around it within `reach`; see
/// Curvature.h for the method.
PointCurvature FitQuadric(const SheetStencil& around, const Vec3& centre, double reach,
                          QuadricScratch& scratch);

} // namespace lamina
