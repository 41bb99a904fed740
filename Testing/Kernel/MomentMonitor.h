// SPDX-License-Identifier: BSD-3-Clause
// A caller who wants a kernel call to stop at any given moment of it.
#pragma once

#include "Base/Monitor.h"

#include <atomic>
#include <limits>

namespace lamina
{

/// Counts the moments at which a call could be stopped: pieces of its loops and questions whether to go on.
/// At the one numbered `stopAt` it is asked to stop.
class MomentMonitor : public ThreadMonitor
{
public:
  explicit MomentMonitor(Id stopAt = std::numeric_limits<Id>::max(), int threads = 1)
    : ThreadMonitor(threads)
    , StopAt(stopAt)
  {
  }
  Id Moments() const { return this->Count.load(); }
  bool Cancelled() override
  {
    this->Tick();
    return this->ThreadMonitor::Cancelled();
  }
  void For(Id count, Id grain, const Chunk& chunk) override
  {
    this->ThreadMonitor::For(count, grain,
                             [&](Id begin, Id end)
                             {
                               this->Tick();
                               chunk(begin, end);
                             });
  }

private:
  void Tick()
  {
    if (this->Count.fetch_add(1) + 1 >= this->StopAt)
    {
      this->Cancel();
    }
  }

  Id StopAt;
  std::atomic<Id> Count{ 0 };
};

} // namespace lamina
