// SPDX-License-Identifier: BSD-3-Clause
// Rays through walls of layered tetrahedra: do they meet every layer on the way in and on the way out?
#pragma once

#include "Mesh/Adjacency.h"
#include "Mesh/CellFaces.h"
#include "Mesh/TetFaces.h"
#include "Search/TriangleTree.h"
#include "Volume/LayeredTets.h"

#include <random>
#include <set>

namespace lamina::layers
{

struct RayCount
{
  Id rays = 0;    ///< that ran across a wall of between the least and largest thickness
  Id whole = 0;   ///< and met every LayerIndex up to that of the columns, in and out
  Id flagged = 0; ///< or began or ended on a triangle whose LayersAchieved says that it may not
};

/// Sends `count` rays from random points of the material's wall along the inward normals.
inline RayCount CountRays(const TriangleComplex& surface, const VolumeMesh& mesh,
                          const LayersOnSurface& onSurface, int material, int columnLayers, Id count,
                          double shortest, double longest)
{
  const auto U = [](Id i) { return static_cast<std::size_t>(i); };
  ThreadMonitor monitor(2);
  std::vector<Id> cells;
  std::vector<std::array<Id, 4>> tets;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    if (mesh.materials[U(c)] == material)
    {
      tets.push_back({ { mesh.Cell(c)[0], mesh.Cell(c)[1], mesh.Cell(c)[2], mesh.Cell(c)[3] } });
    }
  }
  const auto neighbours = FindTetNeighbours(tets, static_cast<Id>(mesh.points.size()), monitor);
  // The tet and the face on each wall triangle.
  std::vector<Id> idOf(surface.points.size(), -1);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    if (mesh.interfaceNodeIds[p] >= 0)
    {
      idOf[U(mesh.interfaceNodeIds[p])] = static_cast<Id>(p);
    }
  }
  std::vector<Triangle> walls;
  std::vector<Id> wallIds;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (SideOf(surface.materials[t], material) != 0)
    {
      const Triangle& c = surface.triangles[t];
      walls.push_back({ { idOf[U(c[0])], idOf[U(c[1])], idOf[U(c[2])] } });
      wallIds.push_back(static_cast<Id>(t));
    }
  }
  const FaceTable table(walls, static_cast<Id>(mesh.points.size()));
  std::vector<Id> tetOn(walls.size(), -1);
  for (std::size_t t = 0; t < tets.size(); ++t)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Id wall = neighbours[t][k] < 0 ? table.Find(TetFace(tets[t], k)) : -1;
      if (wall >= 0)
      {
        tetOn[U(wall)] = static_cast<Id>(t);
      }
    }
  }
  // A ray runs across a wall if it leaves not too slanted, and no third side comes nearer than its ends.
  const TriangleTree tree(mesh.points, walls);
  const auto runsAcross = [&](const Vec3& from, const Vec3& way, double t, Id end)
  {
    bool isFree = std::abs(Dot(way, Normalized(AreaVector2(mesh.points, walls[U(end)])))) > 0.5;
    for (const double part : { 0.25, 0.5, 0.75 })
    {
      const double clear = 0.5 * std::min(part, 1 - part) * t;
      isFree = isFree && tree.ClosestPoint(from + part * t * way, clear * clear).triangle < 0;
    }
    return isFree;
  };
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  RayCount result;
  for (Id ray = 0; ray < count; ++ray)
  {
    const std::size_t wall = random() % walls.size();
    const Triangle& c = walls[wall];
    double a = unit(random);
    double b = unit(random);
    if (a + b > 1)
    {
      a = 1 - a;
      b = 1 - b;
    }
    const auto& p = mesh.points;
    const Vec3 from = (1 - a - b) * p[U(c[0])] + a * p[U(c[1])] + b * p[U(c[2])];
    const Vec3 out = Normalized(AreaVector2(p, c));
    const Vec3 way = SideOf(surface.materials[U(wallIds[wall])], material) > 0 ? -1.0 * out : out;
    // Walk: the next face is the first one ahead that the ray leaves by.
    std::vector<std::pair<double, Id>> met;
    double t = 0;
    Id at = tetOn[wall];
    Id last = -1;
    while (at >= 0 && met.size() < 1000)
    {
      double next = 1e300;
      std::size_t face = 0;
      for (std::size_t k = 0; k < 4; ++k)
      {
        const Triangle f = TetFace(tets[U(at)], k);
        const Vec3 n = AreaVector2(p, f);
        const double slope = Dot(n, way);
        const double reach = slope > 0 ? Dot(n, p[U(f[0])] - from) / slope : 1e300;
        if (slope > 0 && reach < next && neighbours[U(at)][k] != last)
        {
          next = reach;
          face = k;
        }
      }
      met.push_back({ 0.5 * (t + next), at });
      t = next;
      last = at;
      const Id other = neighbours[U(at)][face];
      if (other < 0)
      {
        const Id end = table.Find(TetFace(tets[U(at)], face));
        if (t >= shortest && t <= longest && end >= 0 && runsAcross(from, way, t, end))
        {
          ++result.rays;
          std::set<int> in;
          std::set<int> onTheWayOut;
          for (const auto& [place, tet] : met)
          {
            for (Id q : tets[U(tet)])
            {
              (place < 0.5 * t ? in : onTheWayOut).insert(mesh.layerIndex[U(q)]);
            }
          }
          bool isWhole = true;
          for (int k = 1; k <= columnLayers; ++k)
          {
            isWhole = isWhole && in.count(k) == 1 && onTheWayOut.count(k) == 1;
          }
          const bool isFlagged = onSurface.achieved[U(wallIds[wall])] < columnLayers ||
                                 onSurface.achieved[U(wallIds[U(end)])] < columnLayers;
          result.whole += isWhole ? 1 : 0;
          result.flagged += !isWhole && isFlagged ? 1 : 0;
        }
        break;
      }
      at = other;
    }
  }
  return result;
}

} // namespace lamina::layers
