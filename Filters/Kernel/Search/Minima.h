// SPDX-License-Identifier: BSD-3-Clause
// Least values that many threads find together.
#pragma once

#include "../Base/Types.h"

#include <atomic>
#include <cstddef>
#include <memory>

namespace lamina
{

/// Values that threads lower: the least of all is the same in whatever order.
class Minima
{
public:
  Minima(std::size_t count, double value)
    : Values(new std::atomic<double>[count])
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Values[i].store(value, std::memory_order_relaxed);
    }
  }
  double Of(Id i) const { return this->Values[static_cast<std::size_t>(i)].load(std::memory_order_relaxed); }
  void Lower(Id i, double value)
  {
    double old = this->Of(i);
    while (value < old && !this->Values[static_cast<std::size_t>(i)].compare_exchange_weak(
                            old, value, std::memory_order_relaxed))
    {
    }
  }

private:
  std::unique_ptr<std::atomic<double>[]> Values;
};

} // namespace lamina
