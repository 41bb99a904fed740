// SPDX-License-Identifier: BSD-3-Clause
// Elastic registration of two slices, from coarse to fine.
#pragma once

#include "SliceImage.h"

namespace lamina
{

struct SliceRegistrationOptions
{
  int levels = 4;          ///< of the pyramid, each half as fine as the one before; 1..8
  double smoothness = 1.5; ///< reach over which the field is evened out on each level, in pixels; 0.5..20
  double searchRange = 16; ///< greatest displacement, in pixels of the shorter edge; > 0
  double noise = 0.02;     ///< standard deviation of the grey values' noise: fainter structure moves nothing
};

/// The field u with moving(p + u(p)) like fixed(p). Both slices have the same size; grey values should span
/// about 0 to 1.
///
/// On each level of a Gaussian pyramid every pixel's neighbourhood (a Gaussian window) is shifted to where it
/// fits best by Gauss-Newton steps on the squared difference from which the window's own mean is taken, so
/// that a change of brightness moves nothing. Where a neighbourhood has no structure above the noise its
/// shift counts for little, and the field is filled in from places where it does. After P. J. Kostelec, J. B.
/// Weaver and D. M. Healy, Multiresolution elastic image registration, Medical Physics 25 (1998), with
/// windows that overlap in place of a tree of tiles.
SliceField RegisterSlices(const SliceImage& fixed, const SliceImage& moving, const PixelShape& shape,
                          const SliceRegistrationOptions& options);

} // namespace lamina
