// SPDX-License-Identifier: BSD-3-Clause
#include "LayeredTets.h"

#include "../Sizing/RefinementDemand.h"
#include "ImproveLayers.h"
#include "LayerMesh.h"
#include "MeshEstimate.h"
#include "MiddlePoints.h"
#include "PoorLayers.h"

#include <algorithm>

namespace lamina
{

namespace
{

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

/// Layers that stand on each wall as columns. With an even number the two middle ones are left to the core,
/// whose mid-surface points make them; with an odd number the middle one is.
int LayersOfColumn(int layers)
{
  return layers % 2 == 0 ? layers / 2 - 1 : (layers - 1) / 2;
}

std::optional<Error> CheckOptions(const LayeredTetsOptions& options)
{
  if (options.layers < 1 || options.layers > 100)
  {
    return InvalidOption("the number of layers must lie between 1 and 100, not " +
                         std::to_string(options.layers));
  }
  if (!(options.anisotropy > 0))
  {
    return InvalidOption("the anisotropy must be positive, not " + std::to_string(options.anisotropy));
  }
  if (!(options.growth > 0))
  {
    return InvalidOption("the growth ratio must be positive, not " + std::to_string(options.growth));
  }
  return std::nullopt;
}

constexpr int MostAttempts = 4; ///< at a solid, each with more columns stopped

/// Tets of longer shape than this are what was asked for.
constexpr double MostAnisotropy = 4;
/// More columns than this share do not stand badly: the surface is too coarse for so many layers.
constexpr double MostStopped = 0.01;

/// What came of the best attempt so far.
struct Built
{
  double least = -1; ///< 3r/R
  VolumeMesh mesh;
  LayersOnSurface onSurface;
  LayersReport report;
};

/// Layers and core of one solid, appended to the mesh.
class Solid
{
public:
  Solid(const TriangleComplex& surface, const LayeredTetsOptions& options, LayerMesh& layers,
        VolumeMesh& mesh)
    : Surface(surface)
    , Options(options)
    , Layers(layers)
    , Mesh(mesh)
  {
  }
  std::optional<Error> Fill(int material, LayersOnSurface& onSurface, LayersReport& report, Monitor& monitor);

private:
  std::optional<Error> Build(const Wall& wall, const std::vector<char>& stopped, LayersOnSurface& onSurface,
                             LayersReport& report, Monitor& monitor);
  bool MayStop(const std::vector<Id>& nodes, const Wall& wall) const
  {
    return this->Options.anisotropy <= MostAnisotropy &&
           static_cast<double>(nodes.size()) <= MostStopped * static_cast<double>(wall.points.size());
  }
  std::optional<Error> FillCore(const Wall& wall, const Columns& columns, const std::vector<Id>& frontIds,
                                Monitor& monitor);

  const TriangleComplex& Surface;
  const LayeredTetsOptions& Options;
  LayerMesh& Layers;
  VolumeMesh& Mesh;
};

std::optional<Error> Solid::FillCore(const Wall& wall, const Columns& columns,
                                     const std::vector<Id>& frontIds, Monitor& monitor)
{
  TriangleComplex front = FrontOf(wall, columns);
  front.layerSide.clear();
  front.layerHeight.clear(); // the middle points and the layers' own number say how high the core's tets are
  std::vector<Vec3> middle;
  if (this->Options.layers % 2 == 0)
  {
    middle = MiddlePoints(wall, columns, front, this->Options.layers, this->Options.anisotropy, monitor);
  }
  VolumeMesh core;
  SubMonitor part(monitor, 0.4, 0.9);
  const Result<CoreTetsReport> done = MeshCoreTets(front, middle, this->Options.core, core, part);
  if (!done)
  {
    Error error = done.GetError();
    error.message = "the core of material " + std::to_string(wall.material) + ": " + error.message;
    return error;
  }
  // The core's first points are the front's.
  std::vector<Id> ids = frontIds;
  for (std::size_t p = front.points.size(); p < core.points.size(); ++p)
  {
    ids.push_back(this->Layers.AddPoint(core.points[p], -1));
  }
  for (Id c = 0; c < core.CellCount(); ++c)
  {
    const Id* n = core.Cell(c);
    this->Mesh.AddCell<4>(CellType::Tetrahedron, { ids[U(n[0])], ids[U(n[1])], ids[U(n[2])], ids[U(n[3])] },
                          wall.material, 0);
  }
  return std::nullopt;
}

/// Where tets come out poor, layers are too thin for the triangles: their columns stop, and the solid is
/// built anew, as long as that makes it better.
std::optional<Error> Solid::Fill(int material, LayersOnSurface& onSurface, LayersReport& report,
                                 Monitor& monitor)
{
  const Wall wall = MakeWall(this->Surface, material);
  const LayerMesh::Bookmark start = this->Layers.Here();
  const LayersOnSurface before = onSurface;
  const LayersReport reportBefore = report;
  std::vector<char> stopped(wall.points.size(), 0);
  Built best;
  double from = 0; // most solids need one attempt
  for (int attempt = 1;; ++attempt)
  {
    const double to = 0.2 * from + 0.8;
    SubMonitor part(monitor, from, to);
    from = to;
    if (const auto error = this->Build(wall, stopped, onSurface, report, part))
    {
      return error;
    }
    double least = 1;
    const std::vector<Id> poor = ColumnsOfPoor(this->Mesh, start.cells, wall, least);
    if (least <= best.least)
    {
      // The wall's points come first in every attempt, so that the others' ids of them hold.
      this->Mesh = std::move(best.mesh);
      onSurface = std::move(best.onSurface);
      report = std::move(best.report);
      return std::nullopt;
    }
    if (poor.empty() || attempt == MostAttempts || !this->MayStop(poor, wall))
    {
      return std::nullopt;
    }
    best = { least, this->Mesh, onSurface, report };
    for (Id v : poor)
    {
      stopped[U(v)] = 1;
    }
    this->Layers.BackTo(start);
    onSurface = before;
    report = reportBefore;
  }
}

/// Layers, core and their improvement; no columns stand on wall nodes where `stopped` is not 0.
std::optional<Error> Solid::Build(const Wall& wall, const std::vector<char>& stopped,
                                  LayersOnSurface& onSurface, LayersReport& report, Monitor& monitor)
{
  const int columnLayers = LayersOfColumn(this->Options.layers);
  double share = 0; // of the thickness: the columns' layers out of all, with growth towards the middle
  double all = 0;
  double step = 1;
  for (int k = 0; k < (this->Options.layers + 1) / 2; ++k, step *= this->Options.growth)
  {
    share += k < columnLayers ? step : 0;
    all += (this->Options.layers % 2 == 1 && k == this->Options.layers / 2 ? 1 : 2) * step;
  }
  SubMonitor growing(monitor, 0, 0.4);
  ColumnOptions asked{ columnLayers, this->Options.growth, share / all, ColumnCells::Tets };
  asked.stopped = stopped;
  const Result<Columns> columns = GrowColumns(wall, asked, growing);
  if (!columns)
  {
    return columns.GetError();
  }
  const std::size_t firstCell = this->Mesh.types.size();
  const std::vector<Id> frontIds = this->Layers.Add(wall, *columns, ColumnCells::Tets, report);
  if (columnLayers > 0)
  {
    LayerMesh::Mark(wall, *columns, onSurface, report);
  }
  if (const auto error = this->FillCore(wall, *columns, frontIds, monitor))
  {
    return error;
  }
  SubMonitor improving(monitor, 0.9, 1);
  const ImproveTetsReport improved = ImproveLayers(this->Mesh, firstCell, columnLayers, improving);
  this->Layers.MarkLost(wall, *columns, improved.takenFromLayers, onSurface, report);
  return monitor.Cancelled() ? std::optional<Error>(Cancelled()) : std::nullopt;
}

} // namespace

Result<LayersReport> MeshLayeredTets(const TriangleComplex& surface, const LayeredTetsOptions& options,
                                     VolumeMesh& mesh, LayersOnSurface& onSurface, Monitor& monitor)
{
  if (const auto error = CheckOptions(options))
  {
    return *error;
  }
  const Result<std::vector<int>> materials = CheckMaterials(surface, options.materials, "solid");
  if (!materials)
  {
    return materials.GetError();
  }
  mesh = VolumeMesh{};
  onSurface.achieved.assign(surface.triangles.size(), -1);
  onSurface.fraction.assign(surface.triangles.size(), -1);
  LayersReport report;
  if (materials->empty())
  {
    return report;
  }
  const MemoryDemand demand = LayeredTetsDemand(surface, AsItIs(surface), *materials, options.layers);
  if (const auto error = CheckMemory(demand, "tetrahedra", monitor))
  {
    return *error;
  }
  if (const auto error = CheckLayerSurface(surface, monitor))
  {
    return *error;
  }
  LayerMesh layers(surface, mesh);
  for (std::size_t m = 0; m < materials->size(); ++m)
  {
    const double share = 1.0 / static_cast<double>(materials->size());
    SubMonitor part(monitor, share * static_cast<double>(m), share * static_cast<double>(m + 1));
    Solid solid(surface, options, layers, mesh);
    if (const auto error = solid.Fill((*materials)[m], onSurface, report, part))
    {
      return *error;
    }
  }
  report.tets = mesh.CellCount();
  report.leastQuality = LeastQuality(mesh);
  monitor.Progress(1, "layered tetrahedra made");
  return report;
}

} // namespace lamina
