// SPDX-License-Identifier: BSD-3-Clause
// Histograms of images.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/GreyView.h"

#include <vector>

namespace lamina
{

/// A range of grey values, least < greatest.
struct GreyRange
{
  double least;
  double greatest;

  /// The value at a place counted in bins, which may lie between two of them.
  double ValueOf(double bin, int bins) const
  {
    return this->least + (this->greatest - this->least) * bin / bins;
  }
  /// False for NaN.
  bool Holds(double value) const { return value >= this->least && value <= this->greatest; }
  /// The bin of a value that the range holds.
  int BinOf(double value, int bins) const;
};

/// How many values of the range fall into each of so many bins of equal width. Values outside of it, and NaN,
/// are left out. The same for any number of threads.
std::vector<Id> CountValues(const GreyView& grey, const GreyRange& range, int bins, Monitor& monitor);

/// The range without its lowest and its highest thousandth of the values, such as padding and metal.
GreyRange WithoutTails(const GreyView& grey, const GreyRange& range, Monitor& monitor);

} // namespace lamina
