// SPDX-License-Identifier: BSD-3-Clause
// Progress, abort and threads of a running filter.
#include "Inputs.h"

#include "AlgorithmMonitor.h"
#include "Report.h"
#include "Stage.h"

#include "vtkVolumeConservingSmoothing.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

namespace
{

/// Sets AbortExecute once progress is told.
void AbortAtOnce(vtkObject* caller, unsigned long, void*, void*)
{
  vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
}

class Threads
{
public:
  explicit Threads(const char* count) { setenv("VTK_SMP_MAX_THREADS", count, 1); }
  ~Threads() { unsetenv("VTK_SMP_MAX_THREADS"); }
};

} // namespace

TEST(Monitor, EveryIndexOnceForAnyNumberOfThreads)
{
  for (const char* count : { "1", "2", "5" })
  {
    const Threads threads(count);
    vtkNew<vtkSphereSource> filter;
    lamina::AlgorithmMonitor monitor(filter);
    std::vector<int> visits(100000, 0);
    monitor.For(static_cast<lamina::Id>(visits.size()), 100,
                [&](lamina::Id begin, lamina::Id end)
                {
                  for (lamina::Id i = begin; i < end; ++i)
                  {
                    ++visits[static_cast<std::size_t>(i)];
                  }
                });
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), 100000);
  }
}

TEST(Monitor, MoreThanOneThreadWorks)
{
  const Threads threads("2");
  vtkNew<vtkSphereSource> filter;
  lamina::AlgorithmMonitor monitor(filter);
  std::mutex mutex;
  std::set<std::thread::id> ids;
  monitor.For(40, 1,
              [&](lamina::Id, lamina::Id)
              {
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
                const std::lock_guard<std::mutex> lock(mutex);
                ids.insert(std::this_thread::get_id());
              });
  EXPECT_GE(ids.size(), 2u);
}

TEST(Monitor, LongLoopsStopSoonAfterAbort)
{
  const Threads threads("2");
  vtkNew<vtkSphereSource> filter;
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(&AbortAtOnce);
  lamina::AlgorithmMonitor monitor(filter);
  std::atomic<int> done{ 0 };
  const auto start = std::chrono::steady_clock::now();
  filter->AddObserver(vtkCommand::ProgressEvent, abort);
  monitor.For(10000, 1,
              [&](lamina::Id begin, lamina::Id end)
              {
                for (lamina::Id i = begin; i < end; ++i)
                {
                  std::this_thread::sleep_for(std::chrono::milliseconds(1));
                  ++done;
                }
              });
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_TRUE(monitor.Cancelled());
  EXPECT_LT(seconds.count(), 2);
  EXPECT_LT(done, 10000);
}

TEST(Monitor, ExceptionsInThreadsAreErrorsOfTheFilter)
{
  const Threads threads("2");
  vtkNew<vtkSphereSource> filter;
  Watch watch(filter);
  lamina::AlgorithmMonitor monitor(filter);
  const int result = lamina::RunStage(
    filter,
    [&]() -> lamina::Status
    {
      monitor.For(1000, 1, [](lamina::Id, lamina::Id) { throw std::runtime_error("planted"); });
      return lamina::Done{};
    });
  EXPECT_EQ(result, 0);
  EXPECT_NE(watch.Error().find("planted"), std::string::npos);
}

TEST(Monitor, AnAbortedFilterHasNoOutputAndNoError)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);
  vtkNew<vtkVolumeConservingSmoothing> filter;
  filter->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(&AbortAtOnce);
  filter->AddObserver(vtkCommand::ProgressEvent, abort);
  ExpectFine(filter);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(Report, WritesJson)
{
  lamina::Report row;
  row.Add("material", 1);
  lamina::Report report;
  report.Add("passed", true)
    .Add("text", "a \"b\"\n")
    .Add("nothing", std::nan(""))
    .Add("list", std::vector<double>{ 0.5, 2 });
  report.Add("rows", std::vector<lamina::Report>{ row })
    .Add("places", std::vector<lamina::Vec3>{ { 1, 2, 3 } });
  EXPECT_EQ(report.Json(),
            "{\"passed\": true, \"text\": \"a \\\"b\\\" \", \"nothing\": null, \"list\": [0.5, 2], "
            "\"rows\": [{\"material\": 1}], \"places\": [[1, 2, 3]]}");
}
