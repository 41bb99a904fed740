// SPDX-License-Identifier: BSD-3-Clause
// Messages put together from text and numbers.
#pragma once

#include "Types.h"

#include <iomanip>
#include <sstream>
#include <string>

namespace lamina
{

/// All parts in a row; numbers with ten digits.
template<typename... Parts>
std::string Text(const Parts&... parts)
{
  std::ostringstream stream;
  stream.precision(10);
  (stream << ... << parts);
  return stream.str();
}

/// A number as a person reads it, to three digits: "0.142", "1.5e-12".
inline std::string Short(double value)
{
  std::ostringstream stream;
  stream.precision(3);
  stream << value;
  return stream.str();
}

/// How many of what, as a person reads it: "0 openings", "1 opening", "9876 cells", "35.2 k cells", "1.2 M
/// cells".
inline std::string Amount(Id count, const std::string& one, const std::string& many)
{
  std::ostringstream stream;
  const double scale = count < 10000 ? 1 : (count < 999500 ? 1e3 : 1e6);
  const double scaled = static_cast<double>(count) / scale;
  stream << std::fixed << std::setprecision(count < 10000 || scaled >= 99.95 ? 0 : 1) << scaled
         << (scale == 1 ? "" : (scale == 1e3 ? " k" : " M")) << " " << (count == 1 ? one : many);
  return stream.str();
}
inline std::string Amount(Id count, const std::string& one)
{
  return Amount(count, one, one + "s");
}

/// "10 x 20 x 30".
inline std::string SizeText(const std::array<Id, 3>& size)
{
  return Text(size[0], " x ", size[1], " x ", size[2]);
}

} // namespace lamina
