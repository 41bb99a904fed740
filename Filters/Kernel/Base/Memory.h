// SPDX-License-Identifier: BSD-3-Clause
// How much memory there is, and whether what is about to be made fits into it.
#pragma once

#include "Monitor.h"
#include "Result.h"

#include <optional>
#include <string>

namespace lamina
{

constexpr double BytesPerGiB = 1024.0 * 1024.0 * 1024.0;

/// What this process may still take, in bytes: what the machine has available, or what its container or its
/// own limit on address space leaves, if that is less. Infinite where the system does not tell.
double FreeMemory();

/// The most memory this process has held so far, in bytes; 0 where the system does not tell.
double PeakMemory();

/// "3.2 GiB", "12 MiB".
std::string MemoryText(double bytes);

/// What a stage is about to make and what it takes for that, beside the memory that was taken before.
struct MemoryDemand
{
  double cells = 0;
  double bytes = 0; ///< at its peak, child processes included
  double kept = 0;  ///< of these for what it leaves
};

/// An error with the numbers if the monitor knows of less memory than `demand` takes; `what` names the cells.
std::optional<Error> CheckMemory(const MemoryDemand& demand, const char* what, Monitor& monitor);

} // namespace lamina
