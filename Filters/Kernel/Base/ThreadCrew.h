// SPDX-License-Identifier: BSD-3-Clause
// Threads that stay alive between loops.
#pragma once

#include "Types.h"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace lamina
{

/// Runs loops in threads, of which the calling one is the first. The others are made at the first loop that
/// needs them and wait for the next: stages have thousands of loops of less than a millisecond, and a thread
/// costs a tenth of one to make. One thread at a time may call Run(); a loop within a loop runs where it is.
class ThreadCrew
{
public:
  using Chunk = std::function<void(Id begin, Id end)>;

  explicit ThreadCrew(int threads)
    : Count(threads)
  {
  }
  ~ThreadCrew();
  ThreadCrew(const ThreadCrew&) = delete;
  ThreadCrew& operator=(const ThreadCrew&) = delete;

  /// Runs chunk over [begin, end) in pieces of at most `grain`, in any order. If pieces throw, the others are
  /// left out where they have not begun, and the first exception is thrown again here. `stopped` is called in
  /// the calling thread between its pieces: once it returns true, the other pieces are left out.
  void Run(Id begin, Id end, Id grain, const Chunk& chunk, const std::function<bool()>& stopped);

private:
  void Hire();
  void Serve();
  void Work(const std::function<bool()>* stopped);

  int Count;
  std::vector<std::thread> Members; ///< besides the calling thread
  std::mutex Mutex;
  std::condition_variable Wake;
  std::condition_variable Done;
  std::atomic<unsigned long> Round{ 0 }; ///< of loops so far
  int Busy = 0;                          ///< members still at the loop in hand
  bool Leave = false;
  std::atomic<bool> Running{ false };

  // The loop in hand.
  const Chunk* Body = nullptr;
  std::atomic<Id> Next{ 0 };
  Id End = 0;
  Id Grain = 1;
  std::exception_ptr Thrown;
};

} // namespace lamina
