// SPDX-License-Identifier: BSD-3-Clause
// How long a kernel call goes on without asking whether to stop.
#pragma once

#include "Base/Monitor.h"

#include <atomic>
#include <ctime>
#include <string>

namespace lamina
{

/// Takes the longest time of processors between two moments at which the call could be stopped: pieces of its
/// loops and questions whether to go on. With one thread that is the time to answer on a free machine.
class GapMonitor : public ThreadMonitor
{
public:
  using ThreadMonitor::ThreadMonitor;
  void Progress(double, const char* what) override
  {
    this->Phase = what;
    this->Count("before " + this->Phase);
  }
  bool Cancelled() override
  {
    this->Count(this->Phase);
    return this->ThreadMonitor::Cancelled();
  }
  void For(Id count, Id grain, const Chunk& chunk) override
  {
    this->Count(this->Phase);
    this->ThreadMonitor::For(count, grain,
                             [&](Id begin, Id end)
                             {
                               this->Last = std::clock();
                               chunk(begin, end);
                             });
    this->Count(this->Phase);
  }
  double Longest() const { return static_cast<double>(this->Most) / CLOCKS_PER_SEC; }
  const std::string& Where() const { return this->WhereMost; }

private:
  void Count(const std::string& phase)
  {
    const std::clock_t now = std::clock();
    if (now - this->Last > this->Most)
    {
      this->Most = now - this->Last;
      this->WhereMost = phase;
    }
    this->Last = now;
  }

  std::string Phase = "starting";
  std::string WhereMost;
  std::atomic<std::clock_t> Last{ std::clock() };
  std::clock_t Most = 0;
};

} // namespace lamina
