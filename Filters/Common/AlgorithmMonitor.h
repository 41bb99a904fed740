// SPDX-License-Identifier: BSD-3-Clause
// The kernel's monitor over a vtkAlgorithm: its progress and abort flag, and threads by vtkSMPTools.
#pragma once

#include "Base/Monitor.h"

#include <chrono>
#include <string>

class vtkAlgorithm;

namespace lamina
{

/// Made and used in the thread that runs RequestData: progress and abort are looked at from there only. Where
/// VTK's back end is Sequential, as in ParaView's Debian packages, loops run in threads of the monitor's own,
/// else in VTK's. The number of threads is that of VTK_SMP_MAX_THREADS, else that of the cores.
class AlgorithmMonitor : public Monitor
{
public:
  explicit AlgorithmMonitor(vtkAlgorithm* self);
  void Progress(double fraction, const char* what) override;
  bool Cancelled() override;
  void For(Id count, Id grain, const Chunk& chunk) override;
  /// What LimitMemory allows, else what is free.
  double FreeMemory() override;
  /// The memory the call may take, in GiB; 0: what is free when it asks.
  void LimitMemory(double gibibytes) { this->MemoryLimit = gibibytes; }

private:
  using Clock = std::chrono::steady_clock;

  void Tell();
  void RunInVtk(Id count, Id grain, const Chunk& chunk);

  vtkAlgorithm* Self;
  int Threads;
  bool OwnCrew;
  ThreadCrew Crew;
  bool Stop = false;
  double MemoryLimit = 0;
  double Fraction = 0;
  std::string What;
  Clock::time_point Told;
  Clock::time_point Listened;
};

} // namespace lamina
