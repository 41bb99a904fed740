// SPDX-License-Identifier: BSD-3-Clause
#include "HiddenNodes.h"

#include "../Geometry/VisibleDirection.h"
#include "../Mesh/Adjacency.h"

#include <algorithm>
#include <map>

namespace lamina
{

namespace
{

constexpr double leastCosine = 0.4;

/// Whether, for each material, some direction sees all its faces among these triangles.
bool SeesAll(const TriangleComplex& surface, const ListRow& triangles)
{
  std::vector<int> done{ 0 };
  std::vector<Vec3> normals;
  for (Id first : triangles)
  {
    const MaterialPair& pair = surface.materials[static_cast<std::size_t>(first)];
    for (int material : { pair.first, pair.second })
    {
      if (std::find(done.begin(), done.end(), material) != done.end())
      {
        continue;
      }
      done.push_back(material);
      normals.clear();
      Vec3 sum;
      for (Id t : triangles)
      {
        const auto v = static_cast<std::size_t>(t);
        const int side = SideOf(surface.materials[v], material);
        if (side != 0)
        {
          normals.push_back(side * Normalized(AreaVector2(surface.points, surface.triangles[v])));
          sum += normals.back();
        }
      }
      const Vec3 mean = Normalized(sum); // most often it will do
      const bool seen = std::all_of(normals.begin(), normals.end(),
                                    [&](const Vec3& n) { return Dot(mean, n) >= leastCosine; });
      if (!seen && FindVisibleDirection(normals).leastCosine < leastCosine)
      {
        return false;
      }
    }
  }
  return true;
}

using SheetSet = std::vector<int>;

SheetSet SheetsOf(const SheetGraph& sheets, const ListRow& triangles)
{
  SheetSet set;
  for (Id t : triangles)
  {
    set.push_back(sheets.sheetOfTriangle[static_cast<std::size_t>(t)]);
  }
  std::sort(set.begin(), set.end());
  set.erase(std::unique(set.begin(), set.end()), set.end());
  return set;
}

/// The junctions of the input by the sheets that meet there.
class InputJunctions
{
public:
  explicit InputJunctions(const InputSurface& input)
    : Input(input)
    , Edges(MakeEdgeTable(input.Surface().triangles))
    , Star(TrianglesOfPoints(static_cast<Id>(input.Surface().points.size()), input.Surface().triangles))
  {
    const TriangleComplex& surface = input.Surface();
    for (Id e = 0; e < static_cast<Id>(this->Edges.edges.size()); ++e)
    {
      const ListRow at = Row(this->Edges.triangles, e);
      if (IsFeatureEdge(surface, at.first, at.last))
      {
        this->Curves[SheetsOf(input.Sheets(), at)].push_back(e);
      }
    }
    for (Id p = 0; p < static_cast<Id>(surface.points.size()); ++p)
    {
      if ((surface.junctionKind[static_cast<std::size_t>(p)] & 3) == JunctionCorner)
      {
        this->Corners[SheetsOf(input.Sheets(), Row(this->Star, p))].push_back(p);
      }
    }
  }

  /// Whether edges of the curve lie within the tolerance of x and none of them sees all its faces, or what
  /// sheets of the curve have there leaves no direction for all of it, as where the curve turns sharply.
  bool ForbidCurve(const SheetSet& set, const Vec3& x) const
  {
    const auto found = this->Curves.find(set);
    bool any = false;
    bool anySees = false;
    for (Id e : found == this->Curves.end() ? std::vector<Id>{} : found->second)
    {
      const bool isNear = this->IsEdgeNear(e, x);
      any = any || isNear;
      anySees = anySees || (isNear && SeesAll(this->Input.Surface(), Row(this->Edges.triangles, e)));
    }
    return (any && !anySees) || this->ForbidAround(set, x, 1);
  }

  /// Whether the corner's own place in the input, the nearest where the same sheets meet, does not see all
  /// its faces.
  bool ForbidCorner(const SheetSet& set, const Vec3& x) const
  {
    const auto found = this->Corners.find(set);
    if (found == this->Corners.end())
    {
      return false;
    }
    const auto own =
      std::min_element(found->second.begin(), found->second.end(),
                       [&](Id p, Id q) { return Norm2(this->At(p) - x) < Norm2(this->At(q) - x); });
    return !SeesAll(this->Input.Surface(), Row(this->Star, *own));
  }

  bool ForbidSheet(const SheetSet& set, const Vec3& x) const { return this->ForbidAround(set, x, 2); }

private:
  using Table = std::map<SheetSet, std::vector<Id>>;

  /// Whether all that the sheets have within so many tolerances of x, taken together, leaves no direction.
  bool ForbidAround(const SheetSet& set, const Vec3& x, double tolerances) const
  {
    std::vector<Id> around;
    for (int sheet : set)
    {
      const auto place = this->Input.ClosestOnSheet(sheet, x, 1e300);
      if (place.triangle >= 0)
      {
        const std::vector<Id> near =
          this->Input.TrianglesNear(sheet, x, tolerances * this->Input.Tolerance(place));
        around.insert(around.end(), near.begin(), near.end());
      }
    }
    return !around.empty() &&
           !SeesAll(this->Input.Surface(), { around.data(), around.data() + around.size() });
  }
  const Vec3& At(Id p) const { return this->Input.Surface().points[static_cast<std::size_t>(p)]; }
  bool IsEdgeNear(Id e, const Vec3& x) const
  {
    const Edge& edge = this->Edges.edges[static_cast<std::size_t>(e)];
    const Vec3 along = this->At(edge.b) - this->At(edge.a);
    const double w = std::clamp(Dot(x - this->At(edge.a), along) / Norm2(along), 0.0, 1.0);
    const double tolerance = (1 - w) * this->Input.Tolerance(edge.a) + w * this->Input.Tolerance(edge.b);
    return Norm(x - this->At(edge.a) - w * along) <= tolerance;
  }

  const InputSurface& Input;
  EdgeTable Edges;
  Lists Star;
  Table Curves;
  Table Corners;
};

} // namespace

std::vector<char> HiddenFlags(const TriangleComplex& surface, const Lists& star, Monitor& monitor)
{
  std::vector<char> hidden(surface.points.size(), 0);
  monitor.For(static_cast<Id>(hidden.size()), 4096,
              [&](Id begin, Id end)
              {
                for (Id p = begin; p < end; ++p)
                {
                  hidden[static_cast<std::size_t>(p)] = SeesAll(surface, Row(star, p)) ? 0 : 1;
                }
              });
  return hidden;
}

void FindHiddenNodes(const TriangleComplex& surface, const SheetGraph& sheets, const InputSurface& input,
                     RefineSurfaceReport& report, Monitor& monitor)
{
  const auto count = static_cast<Id>(surface.points.size());
  const Lists star = TrianglesOfPoints(count, surface.triangles);
  const std::vector<char> hidden = HiddenFlags(surface, star, monitor);
  for (Id p = 0; p < count; ++p)
  {
    if (hidden[static_cast<std::size_t>(p)])
    {
      report.hiddenPoints.push_back(p);
      report.hiddenPlaces.push_back(surface.points[static_cast<std::size_t>(p)]);
    }
  }
  report.hiddenNodes = static_cast<Id>(report.hiddenPoints.size());
  if (report.hiddenNodes == 0)
  {
    return;
  }
  const InputJunctions junctions(input);
  std::vector<char> forbidden(report.hiddenPoints.size(), 0);
  monitor.For(report.hiddenNodes, 16,
              [&](Id begin, Id end)
              {
                for (Id i = begin; i < end; ++i)
                {
                  const auto p = static_cast<std::size_t>(report.hiddenPoints[static_cast<std::size_t>(i)]);
                  const int kind = surface.junctionKind[p] & 3;
                  const SheetSet set = SheetsOf(sheets, Row(star, static_cast<Id>(p)));
                  const Vec3& x = surface.points[p];
                  forbidden[static_cast<std::size_t>(i)] =
                    kind == JunctionCurve    ? junctions.ForbidCurve(set, x)
                    : kind == JunctionCorner ? junctions.ForbidCorner(set, x)
                                             : junctions.ForbidSheet(set, x);
                }
              });
  report.forbiddenNodes = std::count(forbidden.begin(), forbidden.end(), 1);
}

} // namespace lamina
