// SPDX-License-Identifier: BSD-3-Clause
// What refinement promises of its results, held against what was measured.
#pragma once

#include "RefinementMeasures.h"

#include <string>
#include <vector>

namespace lamina::measures
{

/// What holds for every surface, however rough: a line for each promise that is broken.
inline std::vector<std::string> BrokenGuarantees(const RefinementFigures& figures,
                                                 const RefineSurfaceReport& report)
{
  std::vector<std::string> broken;
  const auto demand = [&](bool holds, const std::string& what)
  {
    if (!holds)
    {
      broken.push_back(what);
    }
  };
  demand(figures.out.ratio <= 1, "the output leaves the input by " + std::to_string(figures.out.ratio) +
                                   " tolerances in " + std::to_string(figures.out.above) + " triangles");
  demand(figures.back.ratio <= 1, "the input leaves the output by " + std::to_string(figures.back.ratio) +
                                    " tolerances in " + std::to_string(figures.back.above) + " triangles");
  demand(figures.volume <= 1e-6,
         "a volume changes by " + std::to_string(1e6 * figures.volume) + " millionths");
  demand(figures.eulerNumbers == 0, std::to_string(figures.eulerNumbers) + " Euler numbers change");
  demand(figures.piecesKept, "the number of sheets or shells changes");
  demand(figures.intersections == 0, std::to_string(figures.intersections) + " pairs intersect");
  demand(StayApart(figures.nearBefore, figures.nearAfter),
         "sheets come within " + std::to_string(figures.nearAfter.gap) + " of each other, from " +
           std::to_string(figures.nearBefore.gap));
  demand(figures.narrowed == 0,
         std::to_string(figures.narrowed) + " pairs of triangles come nearer than they may");
  demand(StayOpen(figures.nearBefore, figures.nearAfter),
         "triangles meet at " + std::to_string(figures.nearAfter.angle) + " degrees, before at " +
           std::to_string(figures.nearBefore.angle));
  demand(figures.hidden == report.hiddenNodes, std::to_string(figures.hidden) + " nodes are hidden, and " +
                                                 std::to_string(report.hiddenNodes) + " reported");
  return broken;
}

/// All promises, for a smooth surface with sizes of its own.
inline std::vector<std::string> BrokenPromises(const RefinementFigures& figures,
                                               const RefineSurfaceReport& report)
{
  std::vector<std::string> broken = BrokenGuarantees(figures, report);
  const auto demand = [&](bool holds, const std::string& what)
  {
    if (!holds)
    {
      broken.push_back(what);
    }
  };
  demand(figures.edgesInRange >= 0.99,
         "only " + std::to_string(100 * figures.edgesInRange) + " % of the edges are in range");
  demand(figures.goodTriangles >= 0.999,
         "only " + std::to_string(100 * figures.goodTriangles) + " % of the triangles are good");
  demand(figures.badTriangles == 0, std::to_string(figures.badTriangles) +
                                      " triangles are below 0.3, one at " +
                                      std::to_string(figures.leastQuality));
  demand(static_cast<double>(figures.exempt) <= 1e-4 * static_cast<double>(report.triangles),
         std::to_string(figures.exempt) + " triangles are exempt");
  demand(figures.hidden <= report.forbiddenNodes, std::to_string(figures.hidden) +
                                                    " nodes are hidden, of which the input forbids " +
                                                    std::to_string(report.forbiddenNodes));
  return broken;
}

} // namespace lamina::measures
