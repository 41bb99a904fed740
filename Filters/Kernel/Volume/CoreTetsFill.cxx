// SPDX-License-Identifier: BSD-3-Clause
#include "CoreTetsFill.h"

#include "../Geometry/Predicates.h"
#include "../Mesh/Adjacency.h"
#include "ChildProcess.h"
#include "CoreTetsInput.h"
#include "TetGenRun.h"
#include "TetRegions.h"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace lamina
{
namespace
{

using Tet = std::array<Id, 4>;

/// For the pace of the progress only.
constexpr double TetsPerTriangle = 4;
constexpr double TetsPerSecond = 20000;
constexpr double RadiusOfEdge = 0.61237243569579447; ///< of a regular tet

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

/// The longest edge wanted near each point of the surface, as the circumradius of a regular tet, which is
/// what TetGen compares with.
std::vector<double> SizesWanted(const TriangleComplex& surface, const CoreTetsOptions& options)
{
  std::vector<double> wanted = MeanEdgesAtPoints(surface.points, surface.triangles);
  for (std::size_t p = 0; p < wanted.size(); ++p)
  {
    if (p < surface.targetEdgeLength.size() && surface.targetEdgeLength[p] > 0)
    {
      wanted[p] = surface.targetEdgeLength[p];
    }
    wanted[p] *= options.sizeFactor;
    wanted[p] = RadiusOfEdge * std::min(wanted[p], options.maximumEdge);
  }
  return wanted;
}

/// What TetGen is asked for: tried one after the other until one succeeds.
struct Rung
{
  int number = 1;
  bool isGraded = true; ///< with points that grade sizes from the last layer
  double ratio = 0;     ///< largest circumradius over shortest edge; 0: no refinement at all
};

std::vector<Rung> LadderOf(const CoreTetsOptions& options, bool hasGraded)
{
  constexpr double easyRatio = 2; // from which on refinement is proven to end
  std::vector<Rung> rungs{ { 1, true, options.radiusEdgeRatio } };
  if (hasGraded)
  {
    rungs.push_back({ 2, false, options.radiusEdgeRatio });
  }
  if (options.radiusEdgeRatio < easyRatio)
  {
    rungs.push_back({ 3, false, easyRatio });
  }
  rungs.push_back({ 4, false, 0 });
  return rungs;
}

TetGenTask MakeTask(const TriangleComplex& surface, const std::vector<Vec3>& interior,
                    const CoreTetsOptions& options, double radiusEdgeRatio)
{
  TetGenTask task;
  task.points = surface.points;
  task.facets = surface.triangles;
  task.inserted = interior;
  task.holes = FindHoles(surface);
  task.switches = "Y";
  if (radiusEdgeRatio > 0)
  {
    char ratio[32];
    std::snprintf(ratio, sizeof ratio, "q%.6g", radiusEdgeRatio);
    task.switches += ratio;
    task.sizes = options.maximumEdge > 0 ? SizesWanted(surface, options) : std::vector<double>{};
  }
  return task;
}

/// In a child process, or here if there is no program for it.
Result<TetGenAnswer> Ask(const TetGenTask& task, const CoreTetsOptions& options, Monitor& monitor)
{
  if (options.program.empty())
  {
    return RunTetGen(task);
  }
  const double seconds = TetsPerTriangle / TetsPerSecond * static_cast<double>(task.facets.size());
  auto bytes = RunChild(options.program, Encode(task), 1 + seconds, monitor);
  if (!bytes)
  {
    return bytes.GetError();
  }
  auto answer = DecodeAnswer(*bytes);
  if (!answer)
  {
    return Unreachable("the program " + options.program +
                       " gave no answer that makes sense: is it of this version?");
  }
  return std::move(*answer);
}

/// TetGen's answer against what it was asked.
std::optional<Error> CheckAnswer(const TriangleComplex& surface, const TetGenAnswer& answer,
                                 CoreTetsReport& report)
{
  if (answer.code != 0)
  {
    for (Id f : answer.facets)
    {
      if (f >= 0 && f < static_cast<Id>(surface.triangles.size()))
      {
        report.offendingTriangles.push_back(f);
      }
    }
    return Unreachable("TetGen could not fill the surface: " + answer.message,
                       CentresOf(surface, report.offendingTriangles));
  }
  const Id count = static_cast<Id>(answer.points.size());
  if (answer.points.size() < surface.points.size() ||
      !std::equal(surface.points.begin(), surface.points.end(), answer.points.begin()) ||
      !std::all_of(answer.points.begin(), answer.points.end(), IsFinite))
  {
    return Unreachable("TetGen did not hand back the surface's points as they were");
  }
  for (const Tet& tet : answer.tets)
  {
    if (*std::min_element(tet.begin(), tet.end()) < 0 || *std::max_element(tet.begin(), tet.end()) >= count)
    {
      return Unreachable("TetGen handed back a tetrahedron with a point that is not there");
    }
  }
  return std::nullopt;
}

/// Turns each tet to VTK's order.
std::optional<Error> Orient(TetSet& set)
{
  for (Tet& tet : set.tets)
  {
    const int sign = Orientation(set.points[Index(tet[0])], set.points[Index(tet[1])],
                                 set.points[Index(tet[2])], set.points[Index(tet[3])]);
    if (sign == 0)
    {
      return Unreachable("TetGen left a tetrahedron without volume", { set.points[Index(tet[0])] });
    }
    if (sign < 0)
    {
      std::swap(tet[2], tet[3]);
    }
  }
  return std::nullopt;
}

/// One attempt: TetGen's tets, checked, turned, and with the materials that they lie in.
Result<TetSet> FillOnce(const TriangleComplex& surface, const TetGenTask& task,
                        const CoreTetsOptions& options, CoreTetsReport& report, Monitor& monitor)
{
  auto answer = Ask(task, options, monitor);
  if (!answer)
  {
    return answer.GetError();
  }
  if (auto error = CheckAnswer(surface, *answer, report))
  {
    return *error;
  }
  TetSet set;
  set.points = std::move(answer->points);
  set.tets = std::move(answer->tets);
  if (auto error = Orient(set))
  {
    return *error;
  }
  if (auto error = AssignRegions(surface, set, monitor))
  {
    return *error;
  }
  return set;
}

} // namespace

Result<TetSet> FillCore(const TriangleComplex& surface, const std::vector<Vec3>& graded,
                        const std::vector<Vec3>& interior, const CoreTetsOptions& options,
                        CoreTetsReport& report, Monitor& monitor)
{
  const std::vector<Rung> ladder = LadderOf(options, !graded.empty());
  std::optional<Error> trouble;
  for (const Rung& rung : ladder)
  {
    std::vector<Vec3> inserted = rung.isGraded ? graded : std::vector<Vec3>{};
    inserted.insert(inserted.end(), interior.begin(), interior.end());
    CoreTetsReport own;
    auto set = FillOnce(surface, MakeTask(surface, inserted, options, rung.ratio), options, own, monitor);
    report.rung = rung.number;
    if (set || set.GetError().kind == Failure::Cancelled || monitor.Cancelled())
    {
      report.offendingTriangles.clear();
      return set;
    }
    if (!trouble) // what the others say is about less than was asked for
    {
      trouble = set.GetError();
      report.offendingTriangles = own.offendingTriangles;
    }
    if (set.GetError().kind != Failure::Unreachable)
    {
      break;
    }
  }
  return *trouble;
}

} // namespace lamina
