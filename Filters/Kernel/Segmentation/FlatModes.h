// SPDX-License-Identifier: BSD-3-Clause
// Thresholds from the grey values that fill places of an image.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/GreyView.h"

#include <vector>

namespace lamina
{

/// The grey values, ascending, that fill places of a smoothed image: the peaks of the histogram of its flat
/// voxels, those whose neighbours along no axis differ by more than 6 % of the range, or 12 % where fewer
/// than three are found. Voxels that edges run through fill the valleys of a whole histogram; without them
/// even things of a percent of the image have a peak of their own (J. S. Weszka, A. Rosenfeld, Histogram
/// modification for threshold selection, IEEE Transactions on Systems, Man and Cybernetics 9, 1979). The
/// lowest and the highest thousandth of the values are left out. A peak counts if the valley to each higher
/// one is at most 0.6 of it, deeper than its own chance, and if at least 8 voxels and a thousandth of the
/// flat ones belong to it. At least one if any voxel is flat. `least` and `greatest` are the image's range,
/// least < greatest; values that are not finite do not count.
std::vector<double> FlatModes(const GreyView& smooth, double least, double greatest, Monitor& monitor);

/// Thresholds by the modes of a smoothed image. Of three and more the uppermost two are tissue and blood and
/// what lies below is background: one threshold at 47 % of the way to tissue, and from 40 to 60 % of the way
/// from tissue to blood what may be either. Two: one threshold between them, two materials. Fewer: none.
std::vector<double> ModeThresholds(const std::vector<double>& modes);

} // namespace lamina
