// SPDX-License-Identifier: BSD-3-Clause
#include "PrismLayers.h"

#include "LayerMesh.h"

#include <algorithm>
#include <optional>

namespace lamina
{

namespace
{

std::optional<Error> CheckOptions(const PrismLayersOptions& options)
{
  if (options.layers < 1)
  {
    return InvalidOption("the number of prism layers must be 1 or more, not " +
                         std::to_string(options.layers));
  }
  if (!(options.growth >= 1 && options.growth <= 3))
  {
    return InvalidOption("the growth ratio must lie between 1 and 3, not " + std::to_string(options.growth));
  }
  if (!(options.thickness > 0 && options.thickness <= 0.45))
  {
    return InvalidOption("the thickness of all layers must lie in (0, 0.45] of the feature size, not " +
                         std::to_string(options.thickness));
  }
  return std::nullopt;
}

void Append(const TriangleComplex& part, TriangleComplex& whole)
{
  const Id shift = static_cast<Id>(whole.points.size());
  whole.points.insert(whole.points.end(), part.points.begin(), part.points.end());
  for (const Triangle& t : part.triangles)
  {
    whole.triangles.push_back({ t[0] + shift, t[1] + shift, t[2] + shift });
  }
  whole.layerHeight.insert(whole.layerHeight.end(), part.layerHeight.begin(), part.layerHeight.end());
  whole.materials.insert(whole.materials.end(), part.materials.begin(), part.materials.end());
}

} // namespace

Result<LayersReport> GrowPrismLayers(const TriangleComplex& surface, const PrismLayersOptions& options,
                                     VolumeMesh& mesh, TriangleComplex& front, LayersOnSurface& onSurface,
                                     Monitor& monitor)
{
  if (const auto error = CheckOptions(options))
  {
    return *error;
  }
  const Result<std::vector<int>> materials = CheckMaterials(surface, options.materials, "fluid");
  if (!materials)
  {
    return materials.GetError();
  }
  mesh = VolumeMesh{};
  front = TriangleComplex{};
  onSurface.achieved.assign(surface.triangles.size(), -1);
  onSurface.fraction.assign(surface.triangles.size(), -1);
  LayersReport report;
  if (materials->empty())
  {
    return report;
  }
  if (const auto error = CheckLayerSurface(surface, monitor))
  {
    return *error;
  }
  LayerMesh layers(surface, mesh);
  report.leastQuality = 1;
  for (std::size_t m = 0; m < materials->size(); ++m)
  {
    const double share = 1.0 / static_cast<double>(materials->size());
    SubMonitor part(monitor, share * static_cast<double>(m), share * static_cast<double>(m + 1));
    const Wall wall = MakeWall(surface, (*materials)[m]);
    const Result<Columns> columns =
      GrowColumns(wall, { options.layers, options.growth, options.thickness, ColumnCells::Prisms }, part);
    if (!columns)
    {
      return columns.GetError();
    }
    layers.Add(wall, *columns, ColumnCells::Prisms, report);
    LayerMesh::Mark(wall, *columns, onSurface, report);
    Append(FrontOf(wall, *columns), front);
    std::array<ColumnCell, 3> cells;
    for (Id t = 0; t < static_cast<Id>(wall.triangles.size()); ++t)
    {
      for (int k = 1; k <= options.layers; ++k)
      {
        const int n = CellsOfTriangle(wall, *columns, t, k, ColumnCells::Prisms, cells);
        for (int i = 0; i < n; ++i)
        {
          report.leastQuality =
            std::min(report.leastQuality, QualityOf(wall, *columns, cells[static_cast<std::size_t>(i)]));
        }
      }
    }
  }
  monitor.Progress(1, "prism layers grown");
  return report;
}

} // namespace lamina
