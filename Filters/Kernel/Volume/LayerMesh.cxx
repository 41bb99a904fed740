// SPDX-License-Identifier: BSD-3-Clause
#include "LayerMesh.h"

#include "../Mesh/Closedness.h"
#include "../Search/SelfIntersection.h"

#include <algorithm>

namespace lamina
{

namespace
{

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

} // namespace

LayerMesh::LayerMesh(const TriangleComplex& surface, VolumeMesh& mesh)
  : Surface(surface)
  , Mesh(mesh)
  , PointOfSurface(surface.points.size(), -1)
{
}

Id LayerMesh::AddPoint(const Vec3& place, int layerIndex)
{
  this->Mesh.points.push_back(place);
  this->Mesh.layerIndex.push_back(layerIndex);
  this->Mesh.interfaceNodeIds.push_back(-1);
  return static_cast<Id>(this->Mesh.points.size()) - 1;
}

Id LayerMesh::WallPoint(Id surfacePoint)
{
  Id& id = this->PointOfSurface[U(surfacePoint)];
  if (id < 0)
  {
    id = this->AddPoint(this->Surface.points[U(surfacePoint)], 0);
    this->Mesh.interfaceNodeIds.back() = surfacePoint;
  }
  return id;
}

void LayerMesh::BackTo(const Bookmark& mark)
{
  this->Mesh.points.resize(mark.points);
  this->Mesh.layerIndex.resize(mark.points);
  this->Mesh.interfaceNodeIds.resize(mark.points);
  this->Mesh.types.resize(mark.cells);
  this->Mesh.offsets.resize(mark.cells + 1);
  this->Mesh.connectivity.resize(U(this->Mesh.offsets.back()));
  this->Mesh.materials.resize(mark.cells);
  this->Mesh.layers.resize(mark.cells);
  for (Id& id : this->PointOfSurface)
  {
    id = id < static_cast<Id>(mark.points) ? id : -1;
  }
}

std::vector<Id> LayerMesh::Add(const Wall& wall, const Columns& columns, ColumnCells kind,
                               LayersReport& report)
{
  // Node ids: layer by layer, a stopped column repeats its wall node.
  const std::size_t count = wall.points.size();
  std::vector<std::vector<Id>> ids(U(columns.layers) + 1, std::vector<Id>(count));
  for (std::size_t v = 0; v < count; ++v)
  {
    ids[0][v] = this->WallPoint(wall.surfacePoints[v]);
  }
  this->FirstOfLayers = static_cast<Id>(this->Mesh.points.size());
  for (int k = 1; k <= columns.layers; ++k)
  {
    for (std::size_t v = 0; v < count; ++v)
    {
      const Id node = static_cast<Id>(v);
      ids[U(k)][v] = columns.Stopped(node) ? ids[0][v] : this->AddPoint(columns.Place(wall, node, k), k);
    }
  }
  std::array<ColumnCell, 3> cells;
  for (int k = 1; k <= columns.layers; ++k)
  {
    for (Id t = 0; t < static_cast<Id>(wall.triangles.size()); ++t)
    {
      const int n = CellsOfTriangle(wall, columns, t, k, kind, cells);
      for (int i = 0; i < n; ++i)
      {
        const ColumnCell& cell = cells[static_cast<std::size_t>(i)];
        const auto id = [&](std::size_t c) { return ids[U(cell.nodes[c].layer)][U(cell.nodes[c].node)]; };
        switch (cell.type)
        {
          case CellType::Wedge:
            this->Mesh.AddCell<6>(cell.type, { id(0), id(1), id(2), id(3), id(4), id(5) }, wall.material, k);
            ++report.wedges;
            break;
          case CellType::Pyramid:
            this->Mesh.AddCell<5>(cell.type, { id(0), id(1), id(2), id(3), id(4) }, wall.material, k);
            ++report.pyramids;
            break;
          default:
            this->Mesh.AddCell<4>(cell.type, { id(0), id(1), id(2), id(3) }, wall.material, k);
            ++report.tets;
        }
      }
    }
  }
  return ids[U(columns.layers)];
}

void LayerMesh::Mark(const Wall& wall, const Columns& columns, LayersOnSurface& onSurface,
                     LayersReport& report)
{
  for (std::size_t v = 0; v < wall.points.size(); ++v)
  {
    if (wall.fixed[v])
    {
      continue;
    }
    if (columns.Stopped(static_cast<Id>(v)))
    {
      ++report.stoppedColumns;
      report.stoppedPlaces.push_back(wall.points[v]);
      continue;
    }
    ++report.columns;
    report.thinnedColumns += columns.height[v] < 0.99 * columns.wanted[v] ? 1 : 0;
  }
  for (std::size_t t = 0; t < wall.triangles.size(); ++t)
  {
    bool full = true;
    double share = 1;
    for (Id v : wall.triangles[t])
    {
      full = full && !columns.Stopped(v);
      share = std::min(share, columns.wanted[U(v)] > 0 ? columns.height[U(v)] / columns.wanted[U(v)] : 0);
    }
    // A triangle between two meshed materials keeps the lesser of both sides.
    const std::size_t s = U(wall.surfaceTriangles[t]);
    const int layers = full ? columns.layers : 0;
    onSurface.achieved[s] = onSurface.achieved[s] < 0 ? layers : std::min(onSurface.achieved[s], layers);
    onSurface.fraction[s] = onSurface.fraction[s] < 0 ? share : std::min(onSurface.fraction[s], share);
  }
  for (const WallCap& cap : wall.caps)
  {
    for (Id t : cap.surfaceTriangles)
    {
      onSurface.achieved[U(t)] = 0;
      onSurface.fraction[U(t)] = 0;
    }
  }
}

void LayerMesh::MarkLost(const Wall& wall, const Columns& columns, const std::vector<Id>& points,
                         LayersOnSurface& onSurface, LayersReport& report) const
{
  // Layers' points follow each other layer by layer, those of standing columns only.
  std::vector<Id> standing;
  for (Id v = 0; v < static_cast<Id>(wall.points.size()); ++v)
  {
    standing.insert(standing.end(), columns.Stopped(v) ? 0 : 1, v);
  }
  std::vector<char> isCounted(wall.points.size(), 0);
  for (Id p : points)
  {
    const Id place = p - this->FirstOfLayers;
    const Id perLayer = static_cast<Id>(standing.size());
    if (place < 0 || perLayer == 0 || place >= perLayer * columns.layers)
    {
      continue;
    }
    const Id v = standing[U(place % perLayer)];
    const int left = static_cast<int>(place / perLayer);
    report.shortenedColumns += isCounted[U(v)] == 0 ? 1 : 0;
    isCounted[U(v)] = 1;
    for (Id t : Row(wall.star, v))
    {
      int& achieved = onSurface.achieved[U(wall.surfaceTriangles[U(t)])];
      achieved = std::min(achieved, left);
    }
  }
}

TriangleComplex FrontOf(const Wall& wall, const Columns& columns)
{
  TriangleComplex front;
  for (std::size_t v = 0; v < wall.points.size(); ++v)
  {
    front.points.push_back(columns.Place(wall, static_cast<Id>(v), columns.layers));
    const double last = columns.layers > 0 ? 1 - columns.fraction[U(columns.layers - 1)] : 0;
    front.layerHeight.push_back(last * columns.height[v]);
    front.layerSide.push_back(front.layerHeight.back() * columns.direction[v]);
  }
  for (const Triangle& t : wall.triangles)
  {
    front.triangles.push_back({ t[0], t[2], t[1] });
    front.materials.push_back({ wall.material, 0 });
  }
  return front;
}

Result<std::vector<int>> CheckMaterials(const TriangleComplex& surface, const std::vector<int>& asked,
                                        const char* what)
{
  const std::vector<int> present = MaterialsOf(surface);
  std::vector<int> materials = asked;
  std::sort(materials.begin(), materials.end());
  materials.erase(std::unique(materials.begin(), materials.end()), materials.end());
  for (int material : materials)
  {
    if (!std::binary_search(present.begin(), present.end(), material))
    {
      std::string known;
      for (int p : present)
      {
        known += (known.empty() ? "" : ", ") + std::to_string(p);
      }
      return InvalidOption("material " + std::to_string(material) + " is named as " + what +
                           ", but the surface has only " + (known.empty() ? "none" : known));
    }
  }
  return materials;
}

std::optional<Error> CheckLayerSurface(const TriangleComplex& surface, Monitor& monitor)
{
  if (std::optional<Error> error = CheckClosed(surface, true, monitor))
  {
    return error;
  }
  if (surface.sizedMaterials.empty() && !surface.triangles.empty())
  {
    return InvalidInput("there is no MaterialFeatureSize on the points: run Feature Size first");
  }
  std::optional<Error> error = CheckEmbedded(surface.points, surface.triangles, "the surface", monitor);
  if (error && error->kind == Failure::InvalidInput)
  {
    error->message += ": no layers can grow on it";
  }
  return error;
}

} // namespace lamina
