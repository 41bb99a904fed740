// SPDX-License-Identifier: BSD-3-Clause
#include "AuditSurface.h"

#include "../Mesh/Adjacency.h"
#include "../Mesh/Audit.h"
#include "../Mesh/Closedness.h"
#include "../Mesh/VolumeCorrection.h"
#include "../Search/SelfIntersection.h"
#include "Certificate.h"

#include <algorithm>

namespace lamina
{

namespace
{

std::size_t At(Id i)
{
  return static_cast<std::size_t>(i);
}

void AddFinding(SurfaceAuditReport& report, Id count, const std::string& what,
                const std::vector<Vec3>& places)
{
  if (count > 0)
  {
    report.findings.push_back(std::to_string(count) + " " + what + DescribePlaces(places));
  }
}

void AuditTriangles(const TriangleComplex& surface, SurfaceAuditReport& report,
                    std::vector<unsigned char>& flags)
{
  std::vector<Vec3> places;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (!(Norm2(AreaVector2(surface.points, surface.triangles[t])) > 0))
    {
      ++report.flatTriangles;
      flags[t] |= FlagBadQuality;
      places.push_back(surface.points[At(surface.triangles[t][0])]);
    }
  }
  AddFinding(report, report.flatTriangles, "triangles without an area", places);
}

/// Per material: its triangles, its volume, and the edges where its boundary is open.
void AuditMaterials(const TriangleComplex& surface, SurfaceAuditReport& report,
                    std::vector<unsigned char>& flags, Monitor& monitor)
{
  const std::vector<int> ids = MaterialsOf(surface);
  const std::vector<double> volumes = MaterialVolumes(surface, ids);
  for (std::size_t m = 0; m < ids.size(); ++m)
  {
    const auto bounds = [&](const MaterialPair& pair) { return SideOf(pair, ids[m]) != 0; };
    MaterialSurfaceAudit audit;
    audit.material = ids[m];
    audit.triangles = std::count_if(surface.materials.begin(), surface.materials.end(), bounds);
    audit.volume = volumes[m];
    report.materials.push_back(audit);
  }
  const Lists triangles = TrianglesOfPoints(report.points, surface.triangles);
  std::vector<Vec3> places;
  for (const OpenEdge& edge : FindOpenEdges(surface, monitor))
  {
    if (!edge.IsOpen())
    {
      continue;
    }
    const auto at = std::lower_bound(ids.begin(), ids.end(), edge.material) - ids.begin();
    ++report.materials[At(at)].openEdges;
    places.push_back(0.5 * (surface.points[At(edge.a)] + surface.points[At(edge.b)]));
    for (const Id t : Row(triangles, edge.a))
    {
      const Triangle& corners = surface.triangles[At(t)];
      const bool hasEdge = std::find(corners.begin(), corners.end(), edge.b) != corners.end();
      flags[At(t)] |= hasEdge ? FlagNonConforming : 0;
    }
  }
  AddFinding(report, static_cast<Id>(places.size()),
             "edges where a material's boundary is open or turns its orientation", places);
}

void AuditPoints(const TriangleComplex& surface, SurfaceAuditReport& report)
{
  std::vector<bool> used(surface.points.size(), false);
  for (const Triangle& triangle : surface.triangles)
  {
    for (const Id p : triangle)
    {
      used[At(p)] = true;
    }
  }
  report.unusedPoints = std::count(used.begin(), used.end(), false);
  std::vector<Vec3> sorted = surface.points;
  std::sort(sorted.begin(), sorted.end(),
            [](const Vec3& a, const Vec3& b)
            { return a.x != b.x ? a.x < b.x : (a.y != b.y ? a.y < b.y : a.z < b.z); });
  std::vector<Vec3> places;
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    if (sorted[i] == sorted[i - 1])
    {
      ++report.duplicatePoints;
      places.push_back(sorted[i]);
    }
  }
  AddFinding(report, report.duplicatePoints, "points that occur twice", places);
  AddFinding(report, report.unusedPoints, "points that no triangle uses", {});
}

void AuditIntersections(const TriangleComplex& surface, SurfaceAuditReport& report,
                        std::vector<unsigned char>& flags, Monitor& monitor)
{
  std::vector<Vec3> places;
  const auto pairs = FindIntersections(surface.points, surface.triangles, monitor);
  for (const auto& pair : pairs)
  {
    flags[At(pair[0])] |= FlagOverlap;
    flags[At(pair[1])] |= FlagOverlap;
    places.push_back(surface.points[At(surface.triangles[At(pair[0])][0])]);
  }
  report.intersectingPairs = static_cast<Id>(pairs.size());
  report.leastClearance = pairs.empty() ? LeastClearance(surface, monitor) : 0;
  report.leastAngle = LeastAngle(surface);
  AddFinding(report, report.intersectingPairs, "pairs of triangles that intersect", places);
}

} // namespace

Result<SurfaceAuditReport> AuditSurface(const TriangleComplex& surface, std::vector<unsigned char>& flags,
                                        Monitor& monitor)
{
  SurfaceAuditReport report;
  if (const auto unsound = CheckArrays(surface))
  {
    return *unsound;
  }
  report.points = static_cast<Id>(surface.points.size());
  report.triangles = static_cast<Id>(surface.triangles.size());
  flags.assign(surface.triangles.size(), 0);
  monitor.Progress(0, "Auditing triangles and points");
  AuditTriangles(surface, report, flags);
  AuditPoints(surface, report);
  monitor.Progress(0.2, "Looking for open edges");
  AuditMaterials(surface, report, flags, monitor);
  monitor.Progress(0.5, "Looking for intersections");
  AuditIntersections(surface, report, flags, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  return report;
}

} // namespace lamina
