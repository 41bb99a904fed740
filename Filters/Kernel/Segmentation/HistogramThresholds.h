// SPDX-License-Identifier: BSD-3-Clause
// Thresholds from the histogram of an image.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/GreyView.h"

#include <array>

namespace lamina
{

/// The two values that part the grey values into three classes: those of the largest variance between the
/// classes (N. Otsu, A threshold selection method from gray-level histograms, IEEE Transactions on Systems,
/// Man and Cybernetics 9, 1979). The lowest and the highest thousandth, such as padding and metal, are left
/// out. `least` and `greatest` are the image's range, least < greatest; values that are not finite do not
/// count. Ascending; both lie inside the range. Where fewer than three values occur one class may be empty.
std::array<double, 2> HistogramThresholds(const GreyView& grey, double least, double greatest,
                                          Monitor& monitor);

} // namespace lamina
