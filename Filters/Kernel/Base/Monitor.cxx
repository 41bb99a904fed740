// SPDX-License-Identifier: BSD-3-Clause
#include "Monitor.h"

namespace lamina
{

void ThreadMonitor::For(Id count, Id grain, const Chunk& chunk)
{
  this->Crew.Run(0, count, grain, chunk, [this] { return this->Stop.load(); });
}

} // namespace lamina
