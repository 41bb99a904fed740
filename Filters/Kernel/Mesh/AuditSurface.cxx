// SPDX-License-Identifier: BSD-3-Clause
#include "AuditSurface.h"

#include "Audit.h"

#include <algorithm>
#include <map>

namespace lamina
{

namespace
{

/// One passage of a material's oriented boundary through an edge.
struct Passage
{
  Id low;
  Id high;
  int material;
  int direction; ///< +1 from low to high
  Id triangle;
};

bool SameEdge(const Passage& a, const Passage& b)
{
  return a.low == b.low && a.high == b.high && a.material == b.material;
}

std::size_t At(Id i)
{
  return static_cast<std::size_t>(i);
}

std::vector<Passage> Passages(const TriangleComplex& surface)
{
  std::vector<Passage> all;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Id from = surface.triangles[t][i];
      const Id to = surface.triangles[t][(i + 1) % 3];
      const int direction = from < to ? 1 : -1;
      const MaterialPair pair = surface.materials[t];
      for (const auto& [material, sign] : { std::pair{ pair.first, 1 }, std::pair{ pair.second, -1 } })
      {
        if (material != 0)
        {
          all.push_back(
            { std::min(from, to), std::max(from, to), material, sign * direction, static_cast<Id>(t) });
        }
      }
    }
  }
  std::sort(all.begin(), all.end(),
            [](const Passage& a, const Passage& b)
            {
              return a.material != b.material ? a.material < b.material
                                              : (a.low != b.low ? a.low < b.low : a.high < b.high);
            });
  return all;
}

void FindOpenEdges(const TriangleComplex& surface, std::map<int, MaterialSurfaceAudit>& materials,
                   std::vector<unsigned char>& flags, std::vector<Vec3>& places)
{
  const std::vector<Passage> all = Passages(surface);
  for (std::size_t i = 0, j = 0; i < all.size(); i = j)
  {
    int sum = 0;
    for (j = i; j < all.size() && SameEdge(all[i], all[j]); ++j)
    {
      sum += all[j].direction;
    }
    if (sum == 0)
    {
      continue;
    }
    ++materials[all[i].material].openEdges;
    places.push_back(0.5 * (surface.points[At(all[i].low)] + surface.points[At(all[i].high)]));
    for (std::size_t k = i; k < j; ++k)
    {
      flags[At(all[k].triangle)] |= FlagNonConforming;
    }
  }
}

void MeasureTriangles(const TriangleComplex& surface, SurfaceAuditReport& report,
                      std::map<int, MaterialSurfaceAudit>& materials, std::vector<unsigned char>& flags,
                      std::vector<Vec3>& places)
{
  const Vec3 origin = surface.points.empty() ? Vec3{} : surface.points.front();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Vec3 a = surface.points[At(surface.triangles[t][0])] - origin;
    const Vec3 b = surface.points[At(surface.triangles[t][1])] - origin;
    const Vec3 c = surface.points[At(surface.triangles[t][2])] - origin;
    if (!(Norm2(Cross(b - a, c - a)) > 0))
    {
      ++report.flatTriangles;
      flags[t] |= FlagBadQuality;
      places.push_back(a + origin);
    }
    const double volume = Dot(a, Cross(b, c)) / 6;
    const MaterialPair pair = surface.materials[t];
    for (const auto& [material, sign] : { std::pair{ pair.first, 1 }, std::pair{ pair.second, -1 } })
    {
      if (material != 0)
      {
        ++materials[material].triangles;
        materials[material].volume += sign * volume;
      }
    }
  }
}

void CountPoints(const TriangleComplex& surface, SurfaceAuditReport& report, std::vector<Vec3>& places)
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
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    if (sorted[i] == sorted[i - 1])
    {
      ++report.duplicatePoints;
      places.push_back(sorted[i]);
    }
  }
}

void AddFinding(SurfaceAuditReport& report, Id count, const std::string& what,
                const std::vector<Vec3>& places)
{
  if (count > 0)
  {
    report.findings.push_back(std::to_string(count) + " " + what + DescribePlaces(places));
  }
}

} // namespace

Result<SurfaceAuditReport> AuditSurface(const TriangleComplex& surface, std::vector<unsigned char>& flags,
                                        Monitor& monitor)
{
  SurfaceAuditReport report;
  report.points = static_cast<Id>(surface.points.size());
  report.triangles = static_cast<Id>(surface.triangles.size());
  flags.assign(surface.triangles.size(), 0);
  std::map<int, MaterialSurfaceAudit> materials;
  std::vector<Vec3> flat;
  std::vector<Vec3> open;
  std::vector<Vec3> duplicates;
  monitor.Progress(0, "Measuring triangles");
  MeasureTriangles(surface, report, materials, flags, flat);
  monitor.Progress(0.3, "Looking for open edges");
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  FindOpenEdges(surface, materials, flags, open);
  monitor.Progress(0.8, "Comparing points");
  CountPoints(surface, report, duplicates);
  Id openEdges = 0;
  for (auto& [material, audit] : materials)
  {
    audit.material = material;
    openEdges += audit.openEdges;
    report.materials.push_back(audit);
  }
  AddFinding(report, openEdges, "edges where a material's boundary is open or turns its orientation", open);
  AddFinding(report, report.flatTriangles, "triangles without an area", flat);
  AddFinding(report, report.duplicatePoints, "points that occur twice", duplicates);
  AddFinding(report, report.unusedPoints, "points that no triangle uses", {});
  return report;
}

} // namespace lamina
