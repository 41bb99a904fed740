// SPDX-License-Identifier: BSD-3-Clause
#include "LayerReport.h"

#include "vtkAlgorithm.h"
#include "vtkSetGet.h"

#include <algorithm>

namespace lamina
{

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
    .Add("leastQuality", report.leastQuality);
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
