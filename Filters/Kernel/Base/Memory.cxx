// SPDX-License-Identifier: BSD-3-Clause
#include "Memory.h"

#include "Text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>

#include <sys/resource.h>
#include <unistd.h>

namespace lamina
{

namespace
{

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The number a file holds; infinite if it holds none ("max" of a control group) or is not there.
double NumberIn(const std::string& path)
{
  std::ifstream file(path);
  double value = 0;
  return file >> value ? value : unlimited;
}

/// Of the whole machine, without what it would have to swap for.
double FreeOfMachine()
{
  std::ifstream file("/proc/meminfo");
  std::string name;
  double kilobytes = 0;
  std::string unit;
  while (file >> name >> kilobytes && std::getline(file, unit))
  {
    if (name == "MemAvailable:")
    {
      return 1024 * kilobytes;
    }
  }
  return unlimited;
}

/// The number after `word` in a file of words and numbers; 0 without it.
double NumberAfter(const std::string& path, const std::string& word)
{
  std::ifstream file(path);
  double value = 0;
  for (std::string name; file >> name >> value;)
  {
    if (name == word)
    {
      return value;
    }
  }
  return 0;
}

/// Of one control group; what the system caches of files in its name would be given up.
double FreeOfGroup(const std::string& folder, bool isSecond)
{
  const double limit = NumberIn(folder + (isSecond ? "memory.max" : "memory.limit_in_bytes"));
  const double held = NumberIn(folder + (isSecond ? "memory.current" : "memory.usage_in_bytes"));
  const double cached =
    NumberAfter(folder + "memory.stat", isSecond ? "inactive_file" : "total_inactive_file");
  return std::isfinite(limit) && std::isfinite(held) ? limit - held + cached : unlimited;
}

/// Of the control groups this process is in, versions 2 and 1, and of those around them.
double FreeOfContainer()
{
  double least = unlimited;
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);)
  {
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos)
    {
      continue;
    }
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool isSecond = controllers.empty();
    if (!isSecond && controllers.find("memory") == std::string::npos)
    {
      continue;
    }
    // Where the process's own group is not to be seen (inside a container), the one it sees as root is.
    const std::string root = isSecond ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory";
    std::string path = line.substr(second + 1);
    for (bool isLast = false; !isLast;)
    {
      path.erase(path.find_last_not_of('/') + 1);
      isLast = path.empty();
      least = std::min(least, FreeOfGroup(root + path + "/", isSecond));
      path.erase(std::min(path.size(), path.find_last_of('/')));
    }
  }
  return least;
}

/// Of the limit on this process's address space (ulimit -v).
double FreeOfProcess()
{
  rlimit limit{};
  std::ifstream pages("/proc/self/statm");
  double held = 0;
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY || !(pages >> held))
  {
    return unlimited;
  }
  return static_cast<double>(limit.rlim_cur) - held * static_cast<double>(sysconf(_SC_PAGESIZE));
}

} // namespace

double FreeMemory()
{
  return std::max(0.0, std::min({ FreeOfMachine(), FreeOfContainer(), FreeOfProcess() }));
}

double PeakMemory()
{
  rusage usage{};
  return getrusage(RUSAGE_SELF, &usage) == 0 ? 1024.0 * static_cast<double>(usage.ru_maxrss) : 0;
}

std::string MemoryText(double bytes)
{
  char text[32];
  const bool isLarge = bytes >= 0.1 * BytesPerGiB;
  std::snprintf(text, sizeof text, isLarge ? "%.1f GiB" : "%.0f MiB",
                bytes / (isLarge ? BytesPerGiB : BytesPerGiB / 1024));
  return text;
}

std::optional<Error> CheckMemory(const MemoryDemand& demand, const char* what, Monitor& monitor)
{
  const double free = monitor.FreeMemory();
  if (demand.bytes <= free)
  {
    return std::nullopt;
  }
  const auto count = static_cast<Id>(std::min(demand.cells, 1e18));
  return Unreachable(
    "this would make about " + Amount(count, what, what) + " and take about " + MemoryText(demand.bytes) +
    " of memory, but only " + MemoryText(free) +
    " are free: ask for larger sizes or fewer layers, use a machine with more memory, or raise "
    "Memory Limit if you know better");
}

} // namespace lamina
