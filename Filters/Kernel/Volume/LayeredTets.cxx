// SPDX-License-Identifier: BSD-3-Clause
#include "LayeredTets.h"

#include "../Geometry/Quality.h"
#include "../Search/TriangleTree.h"
#include "ImproveTets.h"
#include "LayerMesh.h"

#include <algorithm>
#include <map>

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

/// Points half way between opposite fronts, where an even number of layers has its middle. Points too near to
/// one taken before are left out.
std::vector<Vec3> MiddlePoints(const Wall& wall, const Columns& columns, const TriangleComplex& front,
                               const LayeredTetsOptions& options, Monitor& monitor)
{
  const TriangleTree tree(front.points, front.triangles);
  const std::size_t count = wall.points.size();
  std::vector<Vec3> middle(count);
  std::vector<double> radius(count, 0);
  monitor.For(static_cast<Id>(count), 256,
              [&](Id begin, Id end)
              {
                for (Id v = begin; v < end; ++v)
                {
                  if (wall.fixed[U(v)] || (columns.layers > 0 && columns.Stopped(v)))
                  {
                    continue;
                  }
                  const Vec3& m = columns.direction[U(v)];
                  const double thickness = wall.thickness.empty() ? 0 : wall.thickness[U(v)];
                  const auto hit =
                    tree.FirstHit(front.points[U(v)], m, 1e-3 * thickness, 3.0 * thickness / options.layers,
                                  [&](Id t)
                                  {
                                    const Triangle& c = front.triangles[U(t)];
                                    return c[0] != v && c[1] != v && c[2] != v;
                                  });
                  if (hit.triangle >= 0)
                  {
                    middle[U(v)] = front.points[U(v)] + (0.5 * hit.t) * m;
                    radius[U(v)] = 0.5 * hit.t;
                  }
                }
              });
  // Greedy thinning on a grid, in the order of ids. A radius is a layer's thickness: along the wall points
  // may stand about half as close as the wall's own.
  const double spacing = std::min(1.0, 0.45 * options.anisotropy);
  double cell = 0;
  for (double r : radius)
  {
    cell = std::max(cell, r);
  }
  std::vector<Vec3> kept;
  std::vector<double> keptRadius;
  std::map<std::array<long long, 3>, std::vector<std::size_t>> grid;
  for (std::size_t v = 0; v < count; ++v)
  {
    if (radius[v] == 0)
    {
      continue;
    }
    std::array<long long, 3> at;
    for (int c = 0; c < 3; ++c)
    {
      at[static_cast<std::size_t>(c)] = static_cast<long long>(std::floor(middle[v][c] / cell));
    }
    bool free = true;
    for (int q = 0; q < 27 && free; ++q)
    {
      const auto found = grid.find({ at[0] + q % 3 - 1, at[1] + q / 3 % 3 - 1, at[2] + q / 9 - 1 });
      if (found != grid.end())
      {
        for (std::size_t other : found->second)
        {
          free = free && Norm(kept[other] - middle[v]) > spacing * std::min(radius[v], keptRadius[other]);
        }
      }
    }
    // Not where a third part of the front comes nearer than the two it was put between.
    if (free && tree.ClosestPoint(middle[v], 0.64 * radius[v] * radius[v]).triangle < 0)
    {
      grid[at].push_back(kept.size());
      kept.push_back(middle[v]);
      keptRadius.push_back(radius[v]);
    }
  }
  return kept;
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
  std::optional<Error> FillCore(const Wall& wall, const Columns& columns, const std::vector<Id>& frontIds,
                                Monitor& monitor);
  void Improve(std::size_t firstCell, Monitor& monitor);

  const TriangleComplex& Surface;
  const LayeredTetsOptions& Options;
  LayerMesh& Layers;
  VolumeMesh& Mesh;
};

std::optional<Error> Solid::FillCore(const Wall& wall, const Columns& columns,
                                     const std::vector<Id>& frontIds, Monitor& monitor)
{
  TriangleComplex front = FrontOf(wall, columns);
  std::vector<Vec3> middle;
  if (this->Options.layers % 2 == 0)
  {
    middle = MiddlePoints(wall, columns, front, this->Options, monitor);
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

/// Better tets across the seam of layers and core; the wall stays, and no edge may skip a layer.
void Solid::Improve(std::size_t firstCell, Monitor& monitor)
{
  TetSet set;
  std::vector<Id> local(this->Mesh.points.size(), -1);
  std::vector<Id> global;
  for (std::size_t c = firstCell; c < this->Mesh.types.size(); ++c)
  {
    std::array<Id, 4> tet;
    for (std::size_t i = 0; i < 4; ++i)
    {
      const Id p = this->Mesh.Cell(static_cast<Id>(c))[i];
      if (local[U(p)] < 0)
      {
        local[U(p)] = static_cast<Id>(global.size());
        global.push_back(p);
        set.points.push_back(this->Mesh.points[U(p)]);
        set.fixed.push_back(this->Mesh.layerIndex[U(p)] == 0 ? 1 : 0);
        set.layerIndex.push_back(this->Mesh.layerIndex[U(p)]);
      }
      tet[i] = local[U(p)];
    }
    set.tets.push_back(tet);
  }
  ImproveTets(set, ImproveTetsOptions{}, monitor);
  for (std::size_t p = global.size(); p < set.points.size(); ++p)
  {
    global.push_back(this->Layers.AddPoint(set.points[p], -1));
  }
  const int material = this->Mesh.materials[firstCell];
  this->Mesh.types.resize(firstCell);
  this->Mesh.offsets.resize(firstCell + 1);
  this->Mesh.connectivity.resize(U(this->Mesh.offsets.back()));
  this->Mesh.materials.resize(firstCell);
  this->Mesh.layers.resize(firstCell);
  for (const std::array<Id, 4>& tet : set.tets)
  {
    // The layer of a tet follows from its nodes: between layers k - 1 and k it is k, with a free node it is
    // core.
    int highest = 0;
    bool core = false;
    for (Id p : tet)
    {
      highest = std::max(highest, set.layerIndex[U(p)]);
      core = core || set.layerIndex[U(p)] < 0;
    }
    const int columnLayers = LayersOfColumn(this->Options.layers);
    const bool flat =
      std::all_of(tet.begin(), tet.end(), [&](Id p) { return set.layerIndex[U(p)] == highest; });
    const int layer = core || (flat && highest == columnLayers) ? 0 : std::max(1, highest);
    this->Mesh.AddCell<4>(CellType::Tetrahedron,
                          { global[U(tet[0])], global[U(tet[1])], global[U(tet[2])], global[U(tet[3])] },
                          material, layer);
  }
  for (std::size_t p = 0; p < global.size(); ++p)
  {
    this->Mesh.points[U(global[p])] = set.points[p];
  }
}

std::optional<Error> Solid::Fill(int material, LayersOnSurface& onSurface, LayersReport& report,
                                 Monitor& monitor)
{
  const Wall wall = MakeWall(this->Surface, material);
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
  const Result<Columns> columns =
    GrowColumns(wall, { columnLayers, this->Options.growth, share / all, ColumnCells::Tets }, growing);
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
  this->Improve(firstCell, improving);
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
  report.leastQuality = 1;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    const Id* n = mesh.Cell(c);
    report.leastQuality =
      std::min(report.leastQuality, TetQuality(mesh.points[U(n[0])], mesh.points[U(n[1])],
                                               mesh.points[U(n[2])], mesh.points[U(n[3])]));
  }
  monitor.Progress(1, "layered tetrahedra made");
  return report;
}

} // namespace lamina
