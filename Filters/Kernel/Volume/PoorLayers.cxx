// SPDX-License-Identifier: BSD-3-Clause
#include "PoorLayers.h"

#include "../Geometry/Quality.h"

#include <algorithm>
#include <limits>

namespace lamina
{

namespace
{

constexpr double PoorTet = 0.105; ///< 3r/R

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

double QualityOf(const VolumeMesh& mesh, Id cell)
{
  const auto p = PlacesOf<4>(mesh, cell);
  return TetQuality(p[0], p[1], p[2], p[3]);
}

} // namespace

std::vector<Id> ColumnsOfPoor(const VolumeMesh& mesh, std::size_t firstCell, const Wall& wall, double& least)
{
  std::vector<Id> surfacePoints;
  least = 1;
  for (Id c = static_cast<Id>(firstCell); c < mesh.CellCount(); ++c)
  {
    const double quality = QualityOf(mesh, c);
    least = std::min(least, quality);
    const Id* n = mesh.Cell(c);
    for (int i = 0; i < 4 && quality <= PoorTet; ++i)
    {
      const Vec3& place = mesh.points[U(n[i])];
      Id nearest = -1;
      double distance = std::numeric_limits<double>::infinity();
      for (int k = 0; k < 4 && mesh.layerIndex[U(n[i])] > 0; ++k)
      {
        const double away = Norm2(mesh.points[U(n[k])] - place);
        if (mesh.interfaceNodeIds[U(n[k])] >= 0 && away < distance)
        {
          nearest = mesh.interfaceNodeIds[U(n[k])];
          distance = away;
        }
      }
      surfacePoints.insert(surfacePoints.end(), nearest >= 0 ? 1 : 0, nearest);
    }
  }
  std::sort(surfacePoints.begin(), surfacePoints.end());
  std::vector<Id> nodes;
  for (Id v = 0; v < static_cast<Id>(wall.points.size()); ++v)
  {
    const bool isPoor =
      std::binary_search(surfacePoints.begin(), surfacePoints.end(), wall.surfacePoints[U(v)]);
    nodes.insert(nodes.end(), isPoor ? 1 : 0, v);
  }
  return nodes;
}

double LeastQuality(const VolumeMesh& mesh)
{
  double least = 1;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    least = std::min(least, QualityOf(mesh, c));
  }
  return least;
}

} // namespace lamina
