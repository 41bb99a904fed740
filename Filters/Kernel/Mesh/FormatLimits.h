// SPDX-License-Identifier: BSD-3-Clause
// What a file format can hold: cells, ids, names.
#pragma once

#include "MeshModel.h"

namespace lamina
{

/// What a format can hold.
struct FormatLimits
{
  std::string format;
  bool holdsWedges = true;
  bool holdsPyramids = true;
  bool holdsQuadratic = false;
  bool holdsQuadraticPyramids = false;
  Id largestId = 0;           ///< of nodes, cells and faces; 0: none
  std::size_t nameLength = 0; ///< of a name; 0: any
  bool lettersOnly = true;    ///< names consist of letters, digits, _ and begin with a letter
  bool ignoresCase = false;   ///< names that differ in case only are the same
};

/// The largest number of formats with integers of 32 bits.
constexpr Id LargestInt = 2147483647;

/// Limits of a format that takes all linear cells.
FormatLimits LimitsOf(const std::string& format, Id largestId, std::size_t nameLength);
/// Limits of a format of linear tetrahedra.
FormatLimits TetrahedraOnly(const std::string& format, Id largestId, std::size_t nameLength);

/// A failure if the format cannot hold so many nodes, cells, faces.
Result<bool> CheckCount(const FormatLimits& limits, Id count, const char* what);
/// A failure that says what to do if the format cannot hold the model's cells or ids.
Result<bool> CheckFormat(const FormatLimits& limits, const MeshModel& model);

/// Names as the format takes them: other characters become _, and a name that is too long keeps its beginning
/// and gets a number made from all of its letters, so that it is the same in every file. `notes` gets a
/// sentence for each changed name. All names differ.
std::vector<std::string> FitNames(const FormatLimits& limits, const std::vector<std::string>& names,
                                  std::vector<std::string>& notes);

} // namespace lamina
