// SPDX-License-Identifier: BSD-3-Clause
#include "Base/ThreadCrew.h"

#include <gtest/gtest.h>

#include <chrono>
#include <set>
#include <stdexcept>

using namespace lamina;

namespace
{

const std::function<bool()> never = [] { return false; };

std::vector<int> Visits(ThreadCrew& crew, Id count, Id grain)
{
  std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
  crew.Run(
    0, count, grain,
    [&](Id begin, Id end)
    {
      for (Id i = begin; i < end; ++i)
      {
        ++visits[static_cast<std::size_t>(i)];
      }
    },
    never);
  return { visits.begin(), visits.end() };
}

void Pause()
{
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

} // namespace

TEST(ThreadCrew, VisitsEveryIndexOnceInLoopAfterLoop)
{
  for (int threads : { 1, 2, 5 })
  {
    ThreadCrew crew(threads);
    for (Id count : { 0, 1, 7, 64, 1000, 4097 })
    {
      for (Id grain : { 1, 64, 5000 })
      {
        EXPECT_EQ(Visits(crew, count, grain), std::vector<int>(static_cast<std::size_t>(count), 1));
      }
    }
  }
}

TEST(ThreadCrew, KeepsItsThreadsFromLoopToLoop)
{
  ThreadCrew crew(3);
  std::mutex mutex;
  std::set<std::thread::id> ids;
  for (int loop = 0; loop < 50; ++loop)
  {
    crew.Run(
      0, 30, 1,
      [&](Id, Id)
      {
        Pause();
        const std::lock_guard<std::mutex> lock(mutex);
        ids.insert(std::this_thread::get_id());
      },
      never);
  }
  EXPECT_EQ(ids.size(), 3U);
  EXPECT_EQ(ids.count(std::this_thread::get_id()), 1U);
}

TEST(ThreadCrew, ThrowsTheExceptionOfAnyThreadAndWorksOn)
{
  ThreadCrew crew(4);
  for (Id bad : { 0, 500, 999 })
  {
    const auto chunk = [&](Id begin, Id end)
    {
      if (begin <= bad && bad < end)
      {
        throw std::runtime_error("planted");
      }
    };
    EXPECT_THROW(crew.Run(0, 1000, 1, chunk, never), std::runtime_error);
    EXPECT_EQ(Visits(crew, 100, 1), std::vector<int>(100, 1));
  }
}

TEST(ThreadCrew, RunsALoopWithinALoop)
{
  ThreadCrew crew(3);
  std::atomic<Id> sum{ 0 };
  crew.Run(
    0, 20, 1,
    [&](Id begin, Id end)
    {
      for (Id i = begin; i < end; ++i)
      {
        crew.Run(
          0, 10, 1, [&](Id from, Id to) { sum += to - from; }, never);
      }
    },
    never);
  EXPECT_EQ(sum, 200);
}

TEST(ThreadCrew, LeavesOutWhatComesAfterAStop)
{
  for (int threads : { 1, 3 })
  {
    ThreadCrew crew(threads);
    std::atomic<Id> done{ 0 };
    const std::thread::id caller = std::this_thread::get_id();
    crew.Run(
      0, 100000, 1,
      [&](Id begin, Id end)
      {
        Pause();
        done += end - begin;
      },
      [&]
      {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        return done > 10;
      });
    EXPECT_LT(done, 100000 / 2);
  }
}
