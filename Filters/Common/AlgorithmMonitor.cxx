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
/// The calling thread looks at the abort flag after this time.
constexpr auto ListenEvery = std::chrono::milliseconds(20);
/// A loop in VTK's threads is cut into slices of about this time.
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
  , OwnCrew(std::string(vtkSMPTools::GetBackend()) == "Sequential")
  , Crew(Threads)
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

/// VTK's threads block the calling one. Loops are therefore cut into slices, between which it listens.
void AlgorithmMonitor::RunInVtk(Id count, Id grain, const Chunk& chunk)
{
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
  Id slice = 8 * grain * this->Threads;
  for (Id begin = 0; begin < count && !this->Cancelled();)
  {
    const Id end = std::min(count, begin + slice);
    const auto start = Clock::now();
    vtkSMPTools::For(begin, end, grain, guarded);
    if (thrown)
    {
      std::rethrow_exception(thrown);
    }
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

void AlgorithmMonitor::For(Id count, Id grain, const Chunk& chunk)
{
  grain = std::max<Id>(grain, 1);
  if (!this->OwnCrew)
  {
    this->RunInVtk(count, grain, chunk);
    return;
  }
  const auto stopped = [this]
  {
    if (Clock::now() - this->Listened > ListenEvery)
    {
      this->Listened = Clock::now();
      this->Cancelled();
    }
    return this->Stop;
  };
  if (!this->Cancelled())
  {
    this->Crew.Run(0, count, grain, chunk, stopped);
  }
}

double AlgorithmMonitor::FreeMemory()
{
  return this->MemoryLimit > 0 ? this->MemoryLimit * BytesPerGiB : lamina::FreeMemory();
}

} // namespace lamina
