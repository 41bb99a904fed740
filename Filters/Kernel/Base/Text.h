// SPDX-License-Identifier: BSD-3-Clause
// Messages put together from text and numbers.
#pragma once

#include "Types.h"

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

/// "10 x 20 x 30".
inline std::string SizeText(const std::array<Id, 3>& size)
{
  return Text(size[0], " x ", size[1], " x ", size[2]);
}

} // namespace lamina
