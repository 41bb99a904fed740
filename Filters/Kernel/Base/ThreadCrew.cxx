// SPDX-License-Identifier: BSD-3-Clause
#include "ThreadCrew.h"

#include <algorithm>
#include <system_error>

namespace lamina
{

namespace
{

/// A member looks this often for the next loop before it sleeps: most follow at once.
constexpr int looks = 2000;
/// A loop is cut into so many pieces a thread, and a piece to so much less than its grain, at most.
constexpr Id piecesPerThread = 8;

} // namespace

ThreadCrew::~ThreadCrew()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Leave = true;
    ++this->Round;
  }
  this->Wake.notify_all();
  for (std::thread& member : this->Members)
  {
    member.join();
  }
}

/// Makes the members that are missing, as far as the system grants them.
void ThreadCrew::Hire()
{
  try
  {
    while (static_cast<int>(this->Members.size()) < this->Count - 1)
    {
      this->Members.emplace_back([this] { this->Serve(); });
    }
  }
  catch (const std::system_error&)
  {
    this->Count = 1 + static_cast<int>(this->Members.size());
  }
}

/// Pieces of the loop in hand until none is left; the calling thread listens between its own.
void ThreadCrew::Work(const std::function<bool()>* stopped)
{
  try
  {
    for (Id at = this->Next.fetch_add(this->Grain); at < this->End; at = this->Next.fetch_add(this->Grain))
    {
      (*this->Body)(at, std::min(this->End, at + this->Grain));
      if (stopped != nullptr && (*stopped)())
      {
        this->Next = this->End;
      }
    }
  }
  catch (...)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Thrown = this->Thrown ? this->Thrown : std::current_exception();
    this->Next = this->End;
  }
}

void ThreadCrew::Serve()
{
  for (unsigned long seen = 0;;)
  {
    for (int i = 0; i < looks && this->Round.load() == seen; ++i)
    {
      std::this_thread::yield();
    }
    {
      std::unique_lock<std::mutex> lock(this->Mutex);
      this->Wake.wait(lock, [&] { return this->Round.load() != seen; });
      seen = this->Round.load();
      if (this->Leave)
      {
        return;
      }
    }
    this->Work(nullptr);
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (--this->Busy == 0)
    {
      this->Done.notify_one();
    }
  }
}

void ThreadCrew::Run(Id begin, Id end, Id grain, const Chunk& chunk, const std::function<bool()>& stopped)
{
  // Short loops are cut finer, so that no thread waits long for the last piece.
  const Id share = (end - begin) / (piecesPerThread * std::max(this->Count, 1));
  const Id piece = std::max<Id>(1, std::min(grain, std::max(share, grain / piecesPerThread)));
  const bool isAlone = this->Count <= 1 || end - begin <= piece;
  if (isAlone || this->Running.exchange(true))
  {
    for (; begin < end && !stopped(); begin += piece)
    {
      chunk(begin, std::min(end, begin + piece));
    }
    return;
  }
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Body = &chunk;
    this->Next = begin;
    this->End = end;
    this->Grain = piece;
    this->Thrown = nullptr;
    this->Hire();
    this->Busy = static_cast<int>(this->Members.size());
    ++this->Round;
  }
  this->Wake.notify_all();
  this->Work(&stopped);
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Done.wait(lock, [&] { return this->Busy == 0; });
  this->Body = nullptr;
  this->Running = false;
  if (this->Thrown)
  {
    std::rethrow_exception(this->Thrown);
  }
}

} // namespace lamina
