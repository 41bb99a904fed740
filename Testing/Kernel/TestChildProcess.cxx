// SPDX-License-Identifier: BSD-3-Clause
// TetGen in a process of its own: what goes there and back, and all that can go wrong with it.
#include "CoreChecks.h"
#include "Shapes.h"
#include "Volume/ChildProcess.h"
#include "Volume/TetGenRun.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include <unistd.h>

using namespace lamina;
using namespace cores;

namespace
{

/// A program of a few lines of shell, gone at the end.
class Script
{
public:
  explicit Script(const std::string& text)
    : Path(std::filesystem::temp_directory_path() / ("lamina-child-" + std::to_string(getpid()) + ".sh"))
  {
    std::ofstream(this->Path) << "#!/bin/sh\n" << text << "\n";
    std::filesystem::permissions(this->Path, std::filesystem::perms::owner_all);
  }
  Script(const Script&) = delete;
  Script& operator=(const Script&) = delete;
  ~Script() { std::filesystem::remove(this->Path); }
  std::string Program() const { return this->Path.string(); }

private:
  std::filesystem::path Path;
};

Result<CoreTetsReport> FillBy(const std::string& program, Monitor& monitor)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 3, { 1, 0 });
  CoreTetsOptions options;
  options.program = program;
  VolumeMesh mesh;
  return MeshCoreTets(surface, {}, options, mesh, monitor);
}

} // namespace

TEST(CoreTets, TroubleWithTheProgramIsNamed)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 2, { 1, 0 });
  ThreadMonitor monitor;
  VolumeMesh mesh;
  const auto expect = [&](const char* program, const char* word)
  {
    CoreTetsOptions options;
    options.program = program;
    const auto result = MeshCoreTets(surface, {}, options, mesh, monitor);
    ASSERT_FALSE(result) << program;
    EXPECT_NE(result.GetError().message.find(word), std::string::npos) << result.GetError().message;
  };
  expect("/nowhere/lamina-tetgen", "could not be started");
  expect("/bin/false", "code 1");
  expect("/bin/true", "no answer that makes sense");
  expect("/bin/cat", "no answer that makes sense");
}

TEST(ChildProcess, KilledChildIsNamed)
{
  const Script script("kill -9 $$");
  ThreadMonitor monitor;
  const auto result = FillBy(script.Program(), monitor);
  ASSERT_FALSE(result);
  EXPECT_NE(result.GetError().message.find("signal 9"), std::string::npos) << result.GetError().message;
  EXPECT_NE(result.GetError().message.find("memory"), std::string::npos) << result.GetError().message;
}

TEST(CoreTets, AsksForLessWhereTetGenFails)
{
  // A program that fails for some times, then does its work.
  const auto file = std::filesystem::temp_directory_path() / ("lamina-count-" + std::to_string(getpid()));
  TriangleComplex surface;
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 3, { 1, 0 });
  surface.layerHeight.assign(surface.points.size(), 0.01);
  std::vector<Id> added;
  for (int failures = 0; failures < 5; ++failures)
  {
    std::ofstream(file) << failures;
    const Script script("n=$(cat " + file.string() + "); echo $((n - 1)) > " + file.string() +
                        "; [ $n -gt 0 ] && kill -9 $$; exec " + LAMINA_TETGEN_PROGRAM);
    ThreadMonitor monitor;
    CoreTetsOptions options;
    options.program = script.Program();
    VolumeMesh mesh;
    const auto result = MeshCoreTets(surface, {}, options, mesh, monitor);
    ASSERT_EQ(static_cast<bool>(result), failures < 4) << failures;
    if (!result)
    {
      EXPECT_NE(result.GetError().message.find("signal 9"), std::string::npos) << result.GetError().message;
      continue;
    }
    EXPECT_EQ(result->rung, failures + 1);
    ExpectFills(surface, mesh, { 1 });
    added.push_back(result->addedPoints);
  }
  std::filesystem::remove(file);
  ASSERT_EQ(added.size(), 4u);
  EXPECT_LT(added[1], added[0] / 2) << "no graded points";
  EXPECT_LE(added[2], added[1]) << "a weaker ratio";
  EXPECT_NE(added[3], added[2]) << "no refinement";
}

TEST(ChildProcess, ChildThatNeverEndsIsCancelled)
{
  // One that reads nothing and answers nothing, and one that has closed its ends but goes on.
  for (const char* text : { "exec sleep 1000", "exec sleep 1000 <&- >&-" })
  {
    const Script script(text);
    ThreadMonitor monitor;
    std::thread canceller(
      [&]()
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        monitor.Cancel();
      });
    const auto start = std::chrono::steady_clock::now();
    const auto result = FillBy(script.Program(), monitor);
    canceller.join();
    ASSERT_FALSE(result);
    EXPECT_EQ(result.GetError().kind, Failure::Cancelled);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
  }
}

TEST(ChildProcess, NoMemoryForItIsNamed)
{
  const Script script(std::string("ulimit -v 20000; exec ") + LAMINA_TETGEN_PROGRAM);
  ThreadMonitor monitor;
  const auto result = FillBy(script.Program(), monitor);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.GetError().kind, Failure::Unreachable);
  EXPECT_FALSE(result.GetError().message.empty());
}

TEST(ChildProcess, LargeMessagesPassBothWays)
{
  ThreadMonitor monitor;
  const std::string message(10000000, 'x');
  const auto answer = RunChild("/bin/cat", message, 1, monitor);
  ASSERT_TRUE(answer);
  EXPECT_EQ(*answer, message);
}

TEST(ChildProcess, CancelStopsIt)
{
  ThreadMonitor monitor;
  std::thread canceller(
    [&]()
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      monitor.Cancel();
    });
  const auto start = std::chrono::steady_clock::now();
  TriangleComplex surface;
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 6, { 1, 0 });
  CoreTetsOptions options;
  options.program = LAMINA_TETGEN_PROGRAM;
  options.maximumEdge = 0.01;
  VolumeMesh mesh;
  const auto result = MeshCoreTets(surface, {}, options, mesh, monitor);
  canceller.join();
  ASSERT_FALSE(result);
  EXPECT_EQ(result.GetError().kind, Failure::Cancelled);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

TEST(TetGenMessage, IsWholeOrNothing)
{
  TetGenTask task;
  task.points = { { 1, 2, 3 } };
  task.facets = { { { 0, 1, 2 } } };
  task.switches = "Yq1.4";
  const std::string bytes = Encode(task);
  const auto back = DecodeTask(bytes);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->points, task.points);
  EXPECT_EQ(back->facets, task.facets);
  EXPECT_EQ(back->switches, task.switches);
  for (std::size_t length = 0; length < bytes.size(); ++length)
  {
    EXPECT_FALSE(DecodeTask(bytes.substr(0, length)));
  }
  EXPECT_FALSE(DecodeTask(bytes + "x"));
  EXPECT_FALSE(DecodeAnswer(bytes));
}
