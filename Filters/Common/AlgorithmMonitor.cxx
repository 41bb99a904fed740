// SPDX-License-Identifier: BSD-3-Clause
#include "AlgorithmMonitor.h"

#include "Base/Memory.h"

#include <vtkAlgorithm.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <thread>

namespace lamina
{

namespace
{

constexpr auto TellEvery = std::chrono::milliseconds(100);
/// A loop is cut into slices of about this time, between which the calling thread listens.
constexpr double SliceSeconds = 0.25;

int WantedThreads()
{
  const char* text = std::getenv("VTK_SMP_MAX_THREADS");
  const int asked = text ? std::atoi(text) : 0;
  return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Whether a filter upstream or downstream was stopped, where VTK (9.2 and later) tells.
template<typename Algorithm>
auto StoppedElsewhere(Algorithm* self, int) -> decltype(self->CheckAbort())
{
  return self->CheckAbort();
}
template<typename Algorithm>
bool StoppedElsewhere(Algorithm*, long)
{
  return false;
}

} // namespace

AlgorithmMonitor::AlgorithmMonitor(vtkAlgorithm* self)
  : Self(self)
  , Threads(WantedThreads())
  , OwnScope(std::string(vtkSMPTools::GetBackend()) == "Sequential")
  , Told(Clock::now() - TellEvery)
{
}

void AlgorithmMonitor::Tell()
{
  const auto now = Clock::now();
  if (now - this->Told < TellEvery)
  {
    return;
  }
  this->Told = now;
  this->Self->SetProgressText(this->What.c_str());
  this->Self->UpdateProgress(this->Fraction);
}

void AlgorithmMonitor::Progress(double fraction, const char* what)
{
  this->Fraction = std::clamp(fraction, 0.0, 1.0);
  if (what)
  {
    this->What = what;
  }
  this->Tell();
}

bool AlgorithmMonitor::Cancelled()
{
  this->Tell();
  this->Stop = this->Stop || this->Self->GetAbortExecute() || StoppedElsewhere(this->Self, 0);
  return this->Stop;
}

void AlgorithmMonitor::RunInThreads(Id begin, Id end, Id grain, const Chunk& chunk) const
{
  if (end - begin <= grain || (this->OwnScope && this->Threads == 1))
  {
    chunk(begin, end); // a thread would cost more than it does
    return;
  }
  // An exception must not leave a thread: the first one is kept and thrown again here.
  std::exception_ptr thrown;
  std::once_flag once;
  const auto guarded = [&](vtkIdType b, vtkIdType e)
  {
    try
    {
      chunk(b, e);
    }
    catch (...)
    {
      std::call_once(once, [&] { thrown = std::current_exception(); });
    }
  };
  const auto run = [&] { vtkSMPTools::For(begin, end, grain, guarded); };
  if (this->OwnScope)
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ this->Threads, "STDThread", false }, run);
  }
  else
  {
    run();
  }
  if (thrown)
  {
    std::rethrow_exception(thrown);
  }
}

void AlgorithmMonitor::For(Id count, Id grain, const Chunk& chunk)
{
  grain = std::max<Id>(grain, 1);
  Id slice = 8 * grain * this->Threads;
  for (Id begin = 0; begin < count && !this->Cancelled();)
  {
    const Id end = std::min(count, begin + slice);
    const auto start = Clock::now();
    this->RunInThreads(begin, end, grain, chunk);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (seconds < 0.5 * SliceSeconds)
    {
      slice *= 4;
    }
    else if (seconds > 2 * SliceSeconds)
    {
      slice = std::max(grain * this->Threads, slice / 4);
    }
    begin = end;
  }
}

double AlgorithmMonitor::FreeMemory()
{
  return this->MemoryLimit > 0 ? this->MemoryLimit * BytesPerGiB : lamina::FreeMemory();
}

} // namespace lamina
