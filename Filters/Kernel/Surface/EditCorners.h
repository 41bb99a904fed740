// SPDX-License-Identifier: BSD-3-Clause
// The corners of a triangle, as edits of a surface ask for them.
#pragma once

#include "../Base/Types.h"

#include <cstddef>

namespace lamina
{

/// An id as an index.
inline std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

inline bool Has(const Triangle& t, Id p)
{
  return t[0] == p || t[1] == p || t[2] == p;
}

/// The corner after p, and the one after that.
inline std::array<Id, 2> Others(const Triangle& t, Id p)
{
  const std::size_t at = t[0] == p ? 0 : (t[1] == p ? 1 : 2);
  return { { t[(at + 1) % 3], t[(at + 2) % 3] } };
}

/// The corner that is neither a nor b.
inline Id Third(const Triangle& t, Id a, Id b)
{
  return t[0] + t[1] + t[2] - a - b;
}

} // namespace lamina
