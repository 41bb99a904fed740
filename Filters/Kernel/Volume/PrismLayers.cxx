// SPDX-License-Identifier: BSD-3-Clause
#include "PrismLayers.h"

#include "../Sizing/RefinementDemand.h"
#include "FrontCaps.h"
#include "LayerMesh.h"
#include "MeshEstimate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

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
  if (!(options.total >= 0 && options.firstHeight >= 0 && std::isfinite(options.total + options.firstHeight)))
  {
    return InvalidOption("the first height and the total thickness must be lengths, or 0 for none");
  }
  if (!(options.leastQuality >= 0 && options.leastQuality < 1))
  {
    return InvalidOption("the least quality of prisms must lie in [0, 1), not " +
                         std::to_string(options.leastQuality));
  }
  if (options.total > 0 && options.firstHeight > 0)
  {
    return InvalidOption(
      "the first height and the total thickness are both given: one follows from the other "
      "by the growth ratio");
  }
  return std::nullopt;
}

/// The neighbours named are there, and a length asked for fits somewhere.
std::optional<Error> CheckWalls(const TriangleComplex& surface, const std::vector<int>& materials,
                                const PrismLayersOptions& options)
{
  std::set<int> present;
  double thickest = 0;
  bool carries = false;
  for (int material : materials)
  {
    for (const MaterialPair& pair : surface.materials)
    {
      if (SideOf(pair, material) != 0)
      {
        present.insert(pair.first == material ? pair.second : pair.first);
      }
    }
    const Wall wall = MakeWall(surface, material, { options.neighbours, options.patches, false });
    carries = carries || std::count(wall.fixed.begin(), wall.fixed.end(), 0) > 0;
    for (double t : wall.thickness)
    {
      thickest = std::isfinite(t) ? std::max(thickest, t) : thickest;
    }
  }
  for (int neighbour : options.neighbours)
  {
    if (present.count(neighbour) == 0)
    {
      std::string known;
      for (int p : present)
      {
        known += (known.empty() ? "" : ", ") + std::to_string(p);
      }
      return InvalidOption("no fluid borders material " + std::to_string(neighbour) +
                           ", on which prisms should grow, but " + known);
    }
  }
  if (!carries && !options.patches.empty())
  {
    return InvalidOption("no wall of a fluid has one of the patches on which prisms should grow");
  }
  const double asked = std::max(options.total, options.firstHeight);
  if (asked > thickest)
  {
    return InvalidOption("layers of a height of " + std::to_string(asked) +
                         " fit nowhere: the largest feature size is " + std::to_string(thickest));
  }
  return std::nullopt;
}

/// Joins the fronts of the fluids. Where columns on both sides of a point of the surface have stopped, the
/// fronts share it, and triangles that stand on such points alone part the two fluids.
class JoinedFront
{
public:
  explicit JoinedFront(TriangleComplex& front)
    : Front(front)
  {
  }

  void Add(const Wall& wall, const Columns& columns, const TriangleComplex& part)
  {
    std::vector<Id> idOf(part.points.size());
    for (std::size_t v = 0; v < part.points.size(); ++v)
    {
      const bool isStopped = v < columns.height.size() && columns.height[v] == 0;
      const Id next = static_cast<Id>(this->Front.points.size());
      idOf[v] = isStopped ? this->Stopped.emplace(wall.surfacePoints[v], next).first->second : next;
      if (idOf[v] == next)
      {
        this->Front.points.push_back(part.points[v]);
        this->Front.layerHeight.push_back(part.layerHeight[v]);
        this->Front.layerSide.push_back(part.layerSide[v]);
      }
    }
    for (std::size_t t = 0; t < part.triangles.size(); ++t)
    {
      const Triangle& c = part.triangles[t];
      this->Add({ idOf[static_cast<std::size_t>(c[0])], idOf[static_cast<std::size_t>(c[1])],
                  idOf[static_cast<std::size_t>(c[2])] },
                part.materials[t].first, part.layerSide, c);
    }
  }

private:
  void Add(const Triangle& corners, int material, const std::vector<Vec3>& sides, const Triangle& own)
  {
    const bool isWall =
      std::all_of(own.begin(), own.end(), [&](Id v) { return sides[static_cast<std::size_t>(v)] == Vec3{}; });
    Triangle key = corners;
    std::sort(key.begin(), key.end());
    const Id next = static_cast<Id>(this->Front.triangles.size());
    const Id there = isWall ? this->OnWall.emplace(key, next).first->second : next;
    if (there == next)
    {
      this->Front.triangles.push_back(corners);
      this->Front.materials.push_back({ material, 0 });
      return;
    }
    // Fluids come in ascending order, and the first one's triangle looks out of it.
    this->Front.materials[static_cast<std::size_t>(there)].second = material;
  }

  TriangleComplex& Front;
  std::map<Id, Id> Stopped;      ///< point of the surface to that of the front
  std::map<Triangle, Id> OnWall; ///< by sorted corners
};

struct GrownWall
{
  Wall wall;
  Columns columns;
  TriangleComplex front;
};

/// Columns on the wall of a material, in the planes of its openings where that can be, else up to them.
Result<GrownWall> GrowOnWall(const TriangleComplex& surface, int material, const PrismLayersOptions& options,
                             Monitor& monitor)
{
  const ColumnOptions asked{ options.layers, options.growth,      options.thickness,   ColumnCells::Prisms,
                             options.total,  options.firstHeight, options.leastQuality };
  GrownWall grown;
  for (const bool hasCaps : { true, false })
  {
    grown.wall = MakeWall(surface, material, { options.neighbours, options.patches, hasCaps });
    Result<Columns> columns = GrowColumns(grown.wall, asked, monitor);
    if (!columns && (grown.wall.caps.empty() || columns.GetError().kind == Failure::Cancelled))
    {
      return columns.GetError();
    }
    if (columns)
    {
      grown.columns = std::move(*columns);
      grown.front = FrontOf(grown.wall, grown.columns);
    }
    const bool isClosed = columns && CloseFront(grown.wall, grown.front, monitor);
    if (monitor.Cancelled())
    {
      return Cancelled();
    }
    if (isClosed)
    {
      break;
    }
  }
  return grown;
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
  const MemoryDemand demand = PrismsDemand(surface, AsItIs(surface), *materials, options.layers);
  if (const auto error = CheckMemory(demand, "prisms", monitor))
  {
    return *error;
  }
  if (const auto error = CheckLayerSurface(surface, monitor))
  {
    return *error;
  }
  if (const auto error = CheckWalls(surface, *materials, options))
  {
    return *error;
  }
  LayerMesh layers(surface, mesh);
  JoinedFront joined(front);
  report.leastQuality = 1;
  for (std::size_t m = 0; m < materials->size(); ++m)
  {
    const double share = 1.0 / static_cast<double>(materials->size());
    SubMonitor part(monitor, share * static_cast<double>(m), share * static_cast<double>(m + 1));
    const auto grown = GrowOnWall(surface, (*materials)[m], options, part);
    if (!grown)
    {
      return grown.GetError();
    }
    const auto& [wall, columns, ownFront] = *grown;
    layers.Add(wall, columns, ColumnCells::Prisms, report);
    LayerMesh::Mark(wall, columns, onSurface, report);
    joined.Add(wall, columns, ownFront);
    std::array<ColumnCell, 3> cells;
    for (Id t = 0; t < static_cast<Id>(wall.triangles.size()); ++t)
    {
      for (int k = 1; k <= options.layers; ++k)
      {
        const int n = CellsOfTriangle(wall, columns, t, k, ColumnCells::Prisms, cells);
        for (int i = 0; i < n; ++i)
        {
          report.leastQuality =
            std::min(report.leastQuality, QualityOf(wall, columns, cells[static_cast<std::size_t>(i)]));
        }
      }
    }
  }
  if (!options.endColumns && report.stoppedColumns > 0)
  {
    return Unreachable(
      "no layers can stand at " + std::to_string(report.stoppedColumns) + " points of walls" +
        DescribePlaces(report.stoppedPlaces) +
        ": refine the surface there, ask for fewer layers or a lower quality, or let columns end",
      report.stoppedPlaces);
  }
  monitor.Progress(1, "prism layers grown");
  return report;
}

} // namespace lamina
