// SPDX-License-Identifier: BSD-3-Clause
// What a running kernel call may ask of the world: report progress, ask to stop, run a loop in threads.
#pragma once

#include "ThreadCrew.h"

#include <atomic>
#include <limits>

namespace lamina
{

/// Progress, cancel and threads for a kernel call. One implementation stands on vtkSMPTools (Filters/Common),
/// one on threads of its own (below). Progress() and Cancelled() are called from the calling thread only.
class Monitor
{
public:
  using Chunk = ThreadCrew::Chunk;

  virtual ~Monitor() = default;
  /// Report the share of the work done, in [0, 1], and what is going on.
  virtual void Progress(double fraction, const char* what) = 0;
  /// True once the caller wants the work to stop.
  virtual bool Cancelled() = 0;
  /// Run chunk over [0, count) in pieces of about `grain`, in any order and thread. What a piece writes must
  /// not depend on how the range was cut. Pieces may be left out once Cancelled() is true: test it after the
  /// loop.
  virtual void For(Id count, Id grain, const Chunk& chunk) = 0;
  /// The memory that the call may take, in bytes; infinite if nobody says so.
  virtual double FreeMemory() { return std::numeric_limits<double>::infinity(); }
};

/// A part of another monitor's progress range, for a call inside a call.
class SubMonitor : public Monitor
{
public:
  SubMonitor(Monitor& parent, double from, double to)
    : Parent(parent)
    , From(from)
    , To(to)
  {
  }
  void Progress(double fraction, const char* what) override
  {
    this->Parent.Progress(this->From + fraction * (this->To - this->From), what);
  }
  bool Cancelled() override { return this->Parent.Cancelled(); }
  void For(Id count, Id grain, const Chunk& chunk) override { this->Parent.For(count, grain, chunk); }
  double FreeMemory() override { return this->Parent.FreeMemory(); }

private:
  Monitor& Parent;
  double From;
  double To;
};

/// A monitor with threads of its own, without a listener; Cancel() may be called from any thread.
class ThreadMonitor : public Monitor
{
public:
  explicit ThreadMonitor(int threads = 1)
    : Crew(threads)
  {
  }
  void Progress(double, const char*) override {}
  bool Cancelled() override { return this->Stop.load(); }
  void For(Id count, Id grain, const Chunk& chunk) override;
  void Cancel() { this->Stop = true; }

private:
  ThreadCrew Crew;
  std::atomic<bool> Stop{ false };
};

} // namespace lamina
