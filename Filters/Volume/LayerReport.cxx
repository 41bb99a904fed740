// SPDX-License-Identifier: BSD-3-Clause
#include "LayerReport.h"

#include "Base/Text.h"

#include "vtkAlgorithm.h"
#include "vtkSetGet.h"

#include <algorithm>

namespace lamina
{

namespace
{

std::string LineOf(const LayersReport& report)
{
  std::string line;
  const auto add = [&](Id count, const char* one, const char* many)
  {
    if (count > 0)
    {
      line += (line.empty() ? "" : ", ") + Amount(count, one, many);
    }
  };
  add(report.wedges, "prism", "prisms");
  add(report.pyramids, "pyramid", "pyramids");
  add(report.tets, "tetrahedron", "tetrahedra");
  return line + ", worst " + Short(report.leastQuality) + ", " + Amount(report.stoppedColumns, "place") +
         " without layers, " + Amount(report.thinnedColumns, "place") + " with thinner ones than asked";
}

} // namespace

Report DescribeLayers(const LayersReport& report)
{
  return Report()
    .Add("tets", report.tets)
    .Add("wedges", report.wedges)
    .Add("pyramids", report.pyramids)
    .Add("columns", report.columns)
    .Add("thinnedColumns", report.thinnedColumns)
    .Add("stoppedColumns", report.stoppedColumns)
    .Add("shortenedColumns", report.shortenedColumns)
    .Add("stoppedPlaces", report.stoppedPlaces)
    .Add("leastQuality", report.leastQuality)
    .Tell(LineOf(report));
}

void WarnOfStoppedColumns(vtkAlgorithm* self, const LayersReport& report)
{
  if (report.stoppedColumns > 0)
  {
    vtkWarningWithObjectMacro(self, << report.stoppedColumns << " wall nodes carry no layers"
                                    << DescribePlaces(report.stoppedPlaces));
  }
}

std::vector<int> Without(std::vector<int> ids, const std::vector<int>& others)
{
  const auto isOther = [&](int id) { return std::find(others.begin(), others.end(), id) != others.end(); };
  ids.erase(std::remove_if(ids.begin(), ids.end(), isOther), ids.end());
  return ids;
}

} // namespace lamina
