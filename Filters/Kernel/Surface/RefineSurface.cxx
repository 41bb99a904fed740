// SPDX-License-Identifier: BSD-3-Clause
#include "RefineSurface.h"

#include "../Mesh/Closedness.h"
#include "../Search/SelfIntersection.h"
#include "../Sizing/RefinementDemand.h"
#include "HiddenNodes.h"
#include "RefinedVolumes.h"
#include "Refinement.h"
#include "RefinementResult.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace lamina
{

namespace
{

std::string Text(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

Result<RefineSurfaceReport> Check(const TriangleComplex& surface, const RefineSurfaceOptions& options,
                                  Monitor& monitor)
{
  if (options.iterations < 1)
  {
    return InvalidOption("the number of iterations must be 1 or more, not " +
                         std::to_string(options.iterations));
  }
  if (!(options.splitRatio > 1) || !(options.mergeRatio > 0) || !(options.mergeRatio < 1))
  {
    return InvalidOption("the split ratio must be above 1 and the merge ratio between 0 and 1");
  }
  if (!(options.tolerance >= 0))
  {
    return InvalidOption("the tolerance must be positive, or 0 for a tenth of the feature size");
  }
  if (!(options.tangentialAnisotropy >= 1) || !(options.tangentialAnisotropy <= 4))
  {
    return InvalidOption("the tangential anisotropy must be 1 (edges alike in all directions) to 4");
  }
  if (const std::optional<Error> error = CheckClosed(surface, true, monitor))
  {
    return *error;
  }
  if (!surface.targetEdgeLength.empty() && surface.targetEdgeLength.size() != surface.points.size())
  {
    return InvalidInput("there are " + std::to_string(surface.targetEdgeLength.size()) +
                        " target edge lengths but " + std::to_string(surface.points.size()) +
                        " points: give each point one");
  }
  if (surface.targetEdgeLength.size() != surface.points.size())
  {
    return InvalidInput("there is no target edge length on the points: run Feature Size first, or give an "
                        "array TargetEdgeLength");
  }
  Box box;
  for (const Vec3& p : surface.points)
  {
    box.Add(p);
  }
  const double least = 1e-13 * std::max({ Norm(box.low), Norm(box.high), Norm(box.high - box.low) });
  if (options.tolerance > 0 && options.tolerance < least)
  {
    return InvalidOption("the tolerance " + Text(options.tolerance) +
                         " is below what coordinates can hold here, " + Text(least) +
                         ": give a larger one, or 0 for a tenth of the feature size");
  }
  const auto hasAll = [&](const auto& field) { return field.size() == surface.points.size(); };
  if (options.tangentialAnisotropy > 1 &&
      !(hasAll(surface.maximumCurvature) && hasAll(surface.minimumCurvature) &&
        hasAll(surface.maximumCurvatureDirection)))
  {
    return InvalidInput(
      "a tangential anisotropy above 1 needs the curvatures of the surface: run Feature Size first");
  }
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    if (!(surface.targetEdgeLength[p] > 0) || !std::isfinite(surface.targetEdgeLength[p]))
    {
      return InvalidInput("the target edge length of point " + std::to_string(p) + " is " +
                            std::to_string(surface.targetEdgeLength[p]) + ": it must be positive and finite",
                          { surface.points[p] });
    }
  }
  return RefineSurfaceReport{};
}

} // namespace

Result<RefineSurfaceReport> RefineSurface(TriangleComplex& surface, const RefineSurfaceOptions& options,
                                          Monitor& monitor)
{
  Result<RefineSurfaceReport> checked = Check(surface, options, monitor);
  if (!checked)
  {
    return checked.GetError();
  }
  if (const auto error = CheckMemory(RefinementDemand(surface), "triangles", monitor))
  {
    return *error;
  }
  if (const auto error = CheckEmbedded(surface.points, surface.triangles, "the surface to refine", monitor))
  {
    return *error;
  }
  RefineSurfaceReport report;
  if (surface.triangles.empty())
  {
    return report;
  }
  const std::vector<int> materials = MaterialsOf(surface);
  if (const auto error = CheckSides(surface, materials))
  {
    return *error;
  }
  const std::vector<double> before = MaterialVolumes(surface, materials);
  InputSurface input(surface, options.tolerance, options.tangentialAnisotropy, monitor);
  input.KeepGaps();
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  const std::vector<double> targets = ShellVolumes(surface, input.Sheets());
  EditableSurface editable(input, options.mergeRatio, options.splitRatio);
  Refinement refinement(editable, options, monitor);
  refinement.UncoverNodes(uncoverFirst);
  for (int i = 0; i < options.iterations; ++i)
  {
    monitor.Progress(static_cast<double>(i) / (options.iterations + 1), "refining");
    if (!refinement.Iterate())
    {
      return Cancelled();
    }
  }
  refinement.MendShapes();
  refinement.UncoverNodes(uncoverLast);
  refinement.MendShapes();
  constexpr int stubbornPasses = 3; // what one has moved may free another
  for (int pass = 0; pass < stubbornPasses; ++pass)
  {
    const Id clock = editable.Clock();
    refinement.UncoverNodes(uncoverStubborn);
    if (editable.Clock() == clock)
    {
      break;
    }
    refinement.MendShapes();
  }
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  monitor.Progress(0.95, "restoring volumes");
  TriangleComplex refined;
  editable.Write(refined, monitor);
  RestoreRefinedVolumes(refined, editable.WrittenSheets(), targets, input, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  const std::vector<double> after = MaterialVolumes(refined, materials);
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    report.largestVolumeChange =
      std::max(report.largestVolumeChange, std::abs(after[m] - before[m]) / std::abs(before[m]));
  }
  report.splits = editable.Counts().splits;
  report.merges = editable.Counts().merges;
  report.swaps = editable.Counts().swaps;
  MeasureRefined(refined, editable.WrittenStretches(), report);
  FindHiddenNodes(refined, editable.WrittenSheets(), input, report, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  surface = std::move(refined);
  monitor.Progress(1, "refined");
  return report;
}

} // namespace lamina
