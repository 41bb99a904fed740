// SPDX-License-Identifier: BSD-3-Clause
#include "PlaneEnds.h"

#include "../Mesh/Adjacency.h"

#include <algorithm>
#include <map>

namespace lamina
{
namespace
{

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

class Cutter
{
public:
  Cutter(const TriangleComplex& surface, const PlaneFrame& frame, const std::vector<double>& heights)
    : From(surface)
    , Frame(frame)
    , Heights(heights)
    , Sides(heights.size())
  {
    for (std::size_t p = 0; p < heights.size(); ++p)
    {
      this->Sides[p] = heights[p] > 0 ? 1 : -1;
    }
    this->Made.surface.points = surface.points;
    this->Made.surface.patchNames = surface.patchNames;
  }

  void Snap(const std::vector<char>& region, double share);
  void Clip(const std::vector<char>& region);
  bool Close();
  CutSurface Take() { return std::move(this->Made); }

private:
  Id PointOn(Id a, Id b);
  void Add(const Triangle& corners, const MaterialPair& pair, int patch);

  const TriangleComplex& From;
  const PlaneFrame& Frame;
  std::vector<double> Heights;
  std::vector<signed char> Sides; ///< of the points: below, in, above the plane
  std::map<std::array<Id, 2>, Id> PointOfEdge;
  CutSurface Made;
};

/// Put points close to the plane into it, but never all three of a triangle.
void Cutter::Snap(const std::vector<char>& region, double share)
{
  std::vector<char> isNear(this->Sides.size(), 0);
  for (std::size_t t = 0; t < region.size(); ++t)
  {
    for (std::size_t k = 0; region[t] != 0 && k < 3; ++k)
    {
      const Id a = this->From.triangles[t][k];
      const Id b = this->From.triangles[t][(k + 1) % 3];
      const double ha = std::abs(this->Heights[Index(a)]);
      const double hb = std::abs(this->Heights[Index(b)]);
      if (this->Sides[Index(a)] != this->Sides[Index(b)])
      {
        isNear[Index(a)] |= ha < share * (ha + hb) ? 1 : 0;
        isNear[Index(b)] |= hb < share * (ha + hb) ? 1 : 0;
      }
    }
  }
  const Lists star = TrianglesOfPoints(static_cast<Id>(this->Sides.size()), this->From.triangles);
  for (std::size_t p = 0; p < isNear.size(); ++p)
  {
    const ListRow row = Row(star, static_cast<Id>(p));
    const auto hasTwoInPlane = [&](Id t)
    {
      const Triangle& c = this->From.triangles[Index(t)];
      return std::count_if(c.begin(), c.end(), [&](Id q) { return this->Sides[Index(q)] == 0; }) == 2;
    };
    if (isNear[p] != 0 && std::none_of(row.begin(), row.end(), hasTwoInPlane))
    {
      this->Made.surface.points[p] -= this->Frame.normal * this->Frame.Height(this->Made.surface.points[p]);
      this->Sides[p] = 0;
    }
  }
}

/// Where an edge passes through the plane; one point an edge.
Id Cutter::PointOn(Id a, Id b)
{
  const std::array<Id, 2> edge{ { std::min(a, b), std::max(a, b) } };
  const auto [at, isNew] = this->PointOfEdge.emplace(edge, static_cast<Id>(this->Made.surface.points.size()));
  if (isNew)
  {
    const double ha = this->Heights[Index(edge[0])];
    const double hb = this->Heights[Index(edge[1])];
    const Vec3& from = this->From.points[Index(edge[0])];
    Vec3 p = from + (this->From.points[Index(edge[1])] - from) * (ha / (ha - hb));
    p -= this->Frame.normal * this->Frame.Height(p);
    this->Made.surface.points.push_back(p);
    this->Sides.push_back(0);
  }
  return at->second;
}

void Cutter::Add(const Triangle& corners, const MaterialPair& pair, int patch)
{
  this->Made.surface.triangles.push_back(corners);
  this->Made.surface.materials.push_back(pair);
  this->Made.surface.patches.push_back(patch);
}

void Cutter::Clip(const std::vector<char>& region)
{
  for (std::size_t t = 0; t < region.size(); ++t)
  {
    const Triangle& corners = this->From.triangles[t];
    const MaterialPair pair = this->From.materials[t];
    const int patch = this->From.Patch(static_cast<Id>(t));
    if (region[t] == 0)
    {
      this->Add(corners, pair, patch);
      continue;
    }
    std::array<Id, 4> kept{};
    std::size_t count = 0;
    bool any = false;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id a = corners[k];
      const Id b = corners[(k + 1) % 3];
      if (this->Sides[Index(a)] <= 0)
      {
        kept[count++] = a;
        any = any || this->Sides[Index(a)] < 0;
      }
      if (this->Sides[Index(a)] * this->Sides[Index(b)] < 0)
      {
        kept[count++] = this->PointOn(a, b);
      }
    }
    if (!any)
    {
      continue;
    }
    if (count == 3)
    {
      this->Add({ { kept[0], kept[1], kept[2] } }, pair, patch);
      continue;
    }
    // A quad, by its shorter diagonal.
    const auto& points = this->Made.surface.points;
    const double one = Norm2(points[Index(kept[2])] - points[Index(kept[0])]);
    const double other = Norm2(points[Index(kept[3])] - points[Index(kept[1])]);
    const std::size_t s = one <= other ? 0 : 1;
    this->Add({ { kept[s], kept[s + 1], kept[s + 2] } }, pair, patch);
    this->Add({ { kept[s], kept[s + 2], kept[(s + 3) % 4] } }, pair, patch);
  }
}

bool Cutter::Close()
{
  TriangleComplex& surface = this->Made.surface;
  std::map<Id, Id> placeOf;
  std::vector<Id> pointOf;
  std::vector<Vec2> places;
  const auto place = [&](Id p)
  {
    const auto [at, isNew] = placeOf.emplace(p, static_cast<Id>(places.size()));
    if (isNew)
    {
      places.push_back(this->Frame.ToPlane(surface.points[Index(p)]));
      pointOf.push_back(p);
    }
    return at->second;
  };
  std::map<int, PlaneEdges> edges;
  const double spacing = MeanEdgeLength(this->From);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id a = surface.triangles[t][k];
      const Id b = surface.triangles[t][(k + 1) % 3];
      if (this->Sides[Index(a)] != 0 || this->Sides[Index(b)] != 0)
      {
        continue;
      }
      // The end continues the boundary of each material over this edge, so it runs the other way.
      edges[surface.materials[t].first].push_back({ { place(b), place(a) } });
      if (surface.materials[t].second != 0)
      {
        edges[surface.materials[t].second].push_back({ { place(a), place(b) } });
      }
    }
  }
  for (const auto& [material, own] : edges)
  {
    const std::vector<FlatRegion> regions = FindFlatRegions(places, own);
    if (regions.empty())
    {
      return false;
    }
    for (const FlatRegion& region : regions)
    {
      const std::vector<Triangle> triangles = FillFlatRegion(places, region, spacing);
      if (triangles.empty())
      {
        return false;
      }
      while (pointOf.size() < places.size())
      {
        pointOf.push_back(static_cast<Id>(surface.points.size()));
        surface.points.push_back(this->Frame.ToSpace(places[pointOf.size() - 1]));
      }
      this->Made.ends.push_back(
        { material, static_cast<Id>(surface.triangles.size()), static_cast<Id>(triangles.size()) });
      for (const Triangle& c : triangles)
      {
        this->Add({ { pointOf[Index(c[0])], pointOf[Index(c[1])], pointOf[Index(c[2])] } }, { material, 0 },
                  0);
      }
    }
  }
  return !edges.empty();
}

} // namespace

std::optional<CutSurface> CutAlongPlane(const TriangleComplex& surface, const PlaneFrame& frame,
                                        const std::vector<double>& heights, const std::vector<char>& region,
                                        double snap)
{
  Cutter cutter(surface, frame, heights);
  cutter.Snap(region, snap);
  cutter.Clip(region);
  return cutter.Close() ? std::optional<CutSurface>(cutter.Take()) : std::nullopt;
}

} // namespace lamina
