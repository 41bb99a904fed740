// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/Quality.h"
#include "Mesh/TetFaces.h"
#include "Shapes.h"
#include "Volume/ChildProcess.h"
#include "Volume/CoreTets.h"
#include "Volume/TetGenRun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

#include <unistd.h>

using namespace lamina;

namespace
{

double EnclosedVolume(const TriangleComplex& surface, int material)
{
  double sum = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto corner = [&](std::size_t k)
    { return surface.points[static_cast<std::size_t>(surface.triangles[t][k])]; };
    const double v = Dot(Cross(corner(0), corner(1)), corner(2)) / 6;
    sum += surface.materials[t].first == material ? v : (surface.materials[t].second == material ? -v : 0);
  }
  return sum;
}

std::map<int, double> MeshVolumes(const VolumeMesh& mesh)
{
  std::map<int, double> volumes;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    const Id* p = mesh.Cell(c);
    const auto at = [&](int k) { return mesh.points[static_cast<std::size_t>(p[k])]; };
    const double v = TetVolume(at(0), at(1), at(2), at(3));
    EXPECT_GT(v, 0);
    volumes[mesh.materials[static_cast<std::size_t>(c)]] += v;
  }
  return volumes;
}

void ExpectFills(const TriangleComplex& surface, const VolumeMesh& mesh, std::vector<int> materials)
{
  const auto volumes = MeshVolumes(mesh);
  EXPECT_EQ(volumes.size(), materials.size());
  for (int material : materials)
  {
    const double expected = EnclosedVolume(surface, material);
    ASSERT_EQ(volumes.count(material), 1u) << material;
    EXPECT_NEAR(volumes.at(material), expected, 1e-11 * expected);
  }
  ASSERT_GE(mesh.points.size(), surface.points.size());
  EXPECT_TRUE(std::equal(surface.points.begin(), surface.points.end(), mesh.points.begin()));
  EXPECT_EQ(mesh.interfaceNodeIds.size(), mesh.points.size());
  EXPECT_EQ(mesh.layerIndex.size(), mesh.points.size());
}

std::vector<CoreTetsOptions> BothWays()
{
  CoreTetsOptions child;
  child.program = LAMINA_TETGEN_PROGRAM;
  return { CoreTetsOptions{}, child };
}

} // namespace

TEST(CoreTets, SphereIsFilled)
{
  TriangleComplex surface;
  shapes::AddSphere(surface, { 1, 2, 3 }, 2, 3, { 7, 0 });
  std::vector<VolumeMesh> meshes;
  for (const CoreTetsOptions& options : BothWays())
  {
    ThreadMonitor monitor(meshes.empty() ? 1 : 3);
    VolumeMesh mesh;
    const auto report = MeshCoreTets(surface, {}, options, mesh, monitor);
    ASSERT_TRUE(report) << report.GetError().message;
    ExpectFills(surface, mesh, { 7 });
    EXPECT_EQ(report->tets, mesh.CellCount());
    EXPECT_GT(report->leastQuality, 0.1);
    EXPECT_EQ(report->aboveGate, 1);
    meshes.push_back(mesh);
  }
  EXPECT_EQ(meshes[0].points, meshes[1].points);
  EXPECT_EQ(meshes[0].connectivity, meshes[1].connectivity);
}

TEST(CoreTets, EveryTriangleIsAFaceOfTheMaterialsBesideIt)
{
  // A ball of 1 in a shell of 2 in background, with a cavity in the ball and a separate box of 2.
  TriangleComplex surface;
  shapes::AddSphere(surface, { 0, 0, 0 }, 1, 3, { 1, 2 });
  shapes::AddSphere(surface, { 0, 0, 0 }, 1.5, 3, { 2, 0 });
  TriangleComplex cavity;
  shapes::AddSphere(cavity, { 0.1, 0, 0 }, 0.4, 2, { 1, 0 });
  const Id offset = static_cast<Id>(surface.points.size());
  surface.points.insert(surface.points.end(), cavity.points.begin(), cavity.points.end());
  for (const Triangle& t : cavity.triangles)
  {
    surface.triangles.push_back({ { t[0] + offset, t[2] + offset, t[1] + offset } });
    surface.materials.push_back({ 1, 0 });
  }
  shapes::AddBox(surface, { 3, 0, 0 }, { 4, 1, 1 }, { { 3, 3, 3 } }, { 2, 0 });
  ThreadMonitor monitor(2);
  VolumeMesh mesh;
  const auto report = MeshCoreTets(surface, {}, {}, mesh, monitor);
  ASSERT_TRUE(report) << report.GetError().message;
  ExpectFills(surface, mesh, { 1, 2 });
  // Each triangle has the tet of its first material behind it and that of its second, if any, in front.
  const FaceTable table(surface.triangles, static_cast<Id>(mesh.points.size()));
  std::vector<std::array<int, 2>> seen(surface.triangles.size(), std::array<int, 2>{ { 0, 0 } });
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    const std::array<Id, 4> tet{ { mesh.Cell(c)[0], mesh.Cell(c)[1], mesh.Cell(c)[2], mesh.Cell(c)[3] } };
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Id f = table.Find(TetFace(tet, k));
      if (f >= 0)
      {
        const bool isFirst = TurnAlike(surface.triangles[static_cast<std::size_t>(f)], TetFace(tet, k));
        seen[static_cast<std::size_t>(f)][isFirst ? 0 : 1] = mesh.materials[static_cast<std::size_t>(c)];
      }
    }
  }
  for (std::size_t f = 0; f < seen.size(); ++f)
  {
    EXPECT_EQ(seen[f][0], surface.materials[f].first);
    EXPECT_EQ(seen[f][1], surface.materials[f].second);
  }
}

TEST(CoreTets, InteriorPointsAndSizesAreHonoured)
{
  TriangleComplex surface;
  shapes::AddBox(surface, { 0, 0, 0 }, { 4, 4, 4 }, { { 4, 4, 4 } }, { 1, 0 });
  ThreadMonitor monitor;
  VolumeMesh coarse;
  VolumeMesh fine;
  const std::vector<Vec3> interior{ { 2, 2.1, 2.2 }, { 1.1, 1.2, 1.3 }, { 9, 9, 9 } };
  for (const CoreTetsOptions& options : BothWays())
  {
    ASSERT_TRUE(MeshCoreTets(surface, interior, options, coarse, monitor));
    ExpectFills(surface, coarse, { 1 });
  }
  CoreTetsOptions options;
  options.maximumEdge = 0.5;
  const auto report = MeshCoreTets(surface, interior, options, fine, monitor);
  ASSERT_TRUE(report) << report.GetError().message;
  ExpectFills(surface, fine, { 1 });
  EXPECT_GT(fine.CellCount(), 3 * coarse.CellCount());
}

TEST(CoreTets, BadSurfacesAreRefusedWithPlaces)
{
  ThreadMonitor monitor;
  VolumeMesh mesh;
  TriangleComplex open;
  shapes::AddSphere(open, { 0, 0, 0 }, 1, 2, { 1, 0 });
  open.triangles.pop_back();
  open.materials.pop_back();
  auto result = MeshCoreTets(open, {}, {}, mesh, monitor);
  ASSERT_FALSE(result);
  EXPECT_NE(result.GetError().message.find("open"), std::string::npos);
  EXPECT_EQ(result.GetError().places.size(), 3u);

  TriangleComplex crossing;
  shapes::AddSphere(crossing, { 0, 0, 0 }, 1, 2, { 1, 0 });
  shapes::AddSphere(crossing, { 1.5, 0, 0 }, 1, 2, { 1, 0 });
  CoreTetsReport onFailure;
  result = MeshCoreTets(crossing, {}, {}, mesh, monitor, &onFailure);
  ASSERT_FALSE(result);
  EXPECT_NE(result.GetError().message.find("intersects"), std::string::npos);
  EXPECT_FALSE(onFailure.offendingTriangles.empty());
  EXPECT_EQ(result.GetError().places.size(), onFailure.offendingTriangles.size());

  // A ball of another material that nothing joins to the one around it: (2, 0) inside (1, 0).
  TriangleComplex nested;
  shapes::AddSphere(nested, { 0, 0, 0 }, 1, 2, { 1, 0 });
  shapes::AddSphere(nested, { 0, 0, 0 }, 0.5, 2, { 2, 0 });
  EXPECT_FALSE(MeshCoreTets(nested, {}, {}, mesh, monitor));

  CoreTetsOptions options;
  options.radiusEdgeRatio = 1;
  result = MeshCoreTets(nested, {}, options, mesh, monitor);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.GetError().kind, Failure::InvalidOption);
  EXPECT_TRUE(MeshCoreTets({}, {}, {}, mesh, monitor));
  EXPECT_EQ(mesh.CellCount(), 0);
}

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
