// SPDX-License-Identifier: BSD-3-Clause
#include "Monitor.h"

#include <algorithm>
#include <thread>
#include <vector>

namespace lamina
{

void ThreadMonitor::For(Id count, Id grain, const Chunk& chunk)
{
  const Id step = std::max<Id>(1, grain);
  if (this->Threads <= 1 || count <= step)
  {
    for (Id begin = 0; begin < count && !this->Stop; begin += step)
    {
      chunk(begin, std::min(count, begin + step));
    }
    return;
  }
  std::atomic<Id> next{ 0 };
  auto work = [&]()
  {
    for (Id begin = next.fetch_add(step); begin < count && !this->Stop; begin = next.fetch_add(step))
    {
      chunk(begin, std::min(count, begin + step));
    }
  };
  std::vector<std::thread> crew;
  for (int i = 1; i < this->Threads; ++i)
  {
    crew.emplace_back(work);
  }
  work();
  for (std::thread& member : crew)
  {
    member.join();
  }
}

} // namespace lamina
