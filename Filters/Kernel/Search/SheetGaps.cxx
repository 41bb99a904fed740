// SPDX-License-Identifier: BSD-3-Clause
#include "SheetGaps.h"

#include "Clearance.h"
#include "Facing.h"
#include "Minima.h"
#include "TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lamina
{

namespace
{

constexpr double facingSine = 0.7071; ///< 45 degrees

std::size_t At(Id i)
{
  return static_cast<std::size_t>(i);
}

/// The least distance of two triangles without a common corner is that of two edges, or of a corner and a
/// triangle. Each such pair is measured once, by the first triangles that have them, for all triangles that
/// do.
class GapFinder
{
public:
  GapFinder(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, const EdgeTable& table,
            const Lists& star, double cutoff, const std::vector<MaterialPair>* materials = nullptr)
    : Points(points)
    , Triangles(triangles)
    , Table(table)
    , Star(star)
    , Cutoff(cutoff)
    , Materials(materials)
    , Tree(points, triangles)
    , EdgesOf(triangles.size())
    , Owned(triangles.size(), 0)
    , Any(triangles.size(), cutoff * cutoff)
    , Facing(triangles.size(), cutoff * cutoff)
  {
    this->HalfLength.reserve(table.edges.size());
    for (std::size_t e = 0; e < table.edges.size(); ++e)
    {
      const Edge& edge = table.edges[e];
      const double length = Norm(points[At(edge.b)] - points[At(edge.a)]);
      this->HalfLength.push_back(static_cast<float>(0.5 * (1 + 1e-6) * length));
      for (const Id t : Row(table.triangles, static_cast<Id>(e)))
      {
        const Triangle& c = triangles[At(t)];
        const std::size_t far =
          c[0] != edge.a && c[0] != edge.b ? 0 : (c[1] != edge.a && c[1] != edge.b ? 1 : 2);
        this->EdgesOf[At(t)][far] = static_cast<std::int32_t>(e);
        this->Owned[At(t)] |= *table.triangles.Begin(static_cast<Id>(e)) == t ? 1u << far : 0u;
        this->Owned[At(t)] |= *star.Begin(c[far]) == t ? 8u << far : 0u;
      }
    }
  }

  void Measure(Monitor& monitor);
  /// Triangles need only look for what faces them within the largest of their corners' reaches.
  void Limit(const std::vector<double>& reaches)
  {
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      const Triangle& c = this->Triangles[t];
      const double reach = std::max({ reaches[At(c[0])], reaches[At(c[1])], reaches[At(c[2])] });
      this->Facing.Lower(static_cast<Id>(t), reach * reach);
    }
  }
  SheetGaps OfPoints() const;

private:
  const Vec3& X(Id p) const { return this->Points[At(p)]; }
  void MeasurePair(Id s, Id t);
  void MeasureEdges(Id e, Id f);
  void MeasureCorner(Id p, Id t);
  void Note(Id s, Id t, double distance2, const Vec3& connection, const Vec3& from);
  bool Face(Id s, Id t, double distance2, const Vec3& connection, const Vec3& from) const;

  const std::vector<Vec3>& Points;
  const std::vector<Triangle>& Triangles;
  const EdgeTable& Table;
  const Lists& Star;
  double Cutoff;
  const std::vector<MaterialPair>* Materials; ///< of the triangles, where only true gaps count
  TriangleTree Tree;
  std::vector<std::array<std::int32_t, 3>> EdgesOf; ///< opposite to each corner
  std::vector<unsigned char> Owned; ///< bits of the edges, then of the corners, that a triangle measures
  std::vector<float> HalfLength;    ///< of edges, rounded up
  Minima Any;                       ///< squared, of triangles
  Minima Facing;
};

/// `connection` leads from t to the place `from` on s.
bool GapFinder::Face(Id s, Id t, double distance2, const Vec3& connection, const Vec3& from) const
{
  const Vec3 own = AreaVector2(this->Points, this->Triangles[At(s)]);
  const Vec3 other = AreaVector2(this->Points, this->Triangles[At(t)]);
  const double ownAlong = Dot(own, connection);
  const double otherAlong = Dot(other, connection);
  constexpr double least2 = facingSine * facingSine;
  if (ownAlong * ownAlong < least2 * distance2 * Norm2(own) ||
      otherAlong * otherAlong < least2 * distance2 * Norm2(other))
  {
    return false;
  }
  return this->Materials == nullptr ||
         (MaterialTowards((*this->Materials)[At(s)], -ownAlong) ==
            MaterialTowards((*this->Materials)[At(t)], otherAlong) &&
          !AreJoined(
            from, this->Triangles[At(s)], from - connection, this->Triangles[At(t)],
            shortWay * std::sqrt(distance2), [this](Id p) { return this->X(p); },
            [this](Id p, const auto& visit)
            {
              for (const Id around : Row(this->Star, p))
              {
                for (const Id q : this->Triangles[At(around)])
                {
                  visit(q);
                }
              }
            }));
}

void GapFinder::Note(Id s, Id t, double distance2, const Vec3& connection, const Vec3& from)
{
  const bool isNearest = distance2 < this->Any.Of(s) || distance2 < this->Any.Of(t);
  const bool mayFace = distance2 < this->Facing.Of(s) || distance2 < this->Facing.Of(t);
  if ((!isNearest && !mayFace) || ShareCorner(this->Triangles[At(s)], this->Triangles[At(t)]))
  {
    return;
  }
  this->Any.Lower(s, distance2);
  this->Any.Lower(t, distance2);
  if (mayFace && this->Face(s, t, distance2, connection, from))
  {
    this->Facing.Lower(s, distance2);
    this->Facing.Lower(t, distance2);
  }
}

void GapFinder::MeasureEdges(Id e, Id f)
{
  const Edge& own = this->Table.edges[At(e)];
  const Edge& other = this->Table.edges[At(f)];
  if (own.a == other.a || own.a == other.b || own.b == other.a || own.b == other.b)
  {
    return;
  }
  const Vec3 u = this->X(own.b) - this->X(own.a);
  const Vec3 v = this->X(other.b) - this->X(other.a);
  const Vec3 apart = this->X(own.a) - this->X(other.a) + 0.5 * (u - v);
  const double reach = this->Cutoff + this->HalfLength[At(e)] + this->HalfLength[At(f)];
  if (Norm2(apart) >= reach * reach)
  {
    return;
  }
  const Vec3 connection =
    SegmentConnection(this->X(own.a), this->X(own.b), this->X(other.a), this->X(other.b));
  const double distance2 = Norm2(connection);
  if (distance2 >= this->Cutoff * this->Cutoff)
  {
    return;
  }
  const Vec3 from =
    this->X(own.a) +
    SegmentParameters(this->X(own.a), this->X(own.b), this->X(other.a), this->X(other.b))[0] * u;
  for (const Id s : Row(this->Table.triangles, e))
  {
    for (const Id t : Row(this->Table.triangles, f))
    {
      this->Note(s, t, distance2, connection, from);
    }
  }
}

void GapFinder::MeasureCorner(Id p, Id t)
{
  const Triangle& c = this->Triangles[At(t)];
  if (c[0] == p || c[1] == p || c[2] == p)
  {
    return;
  }
  // Too far off whatever the triangle's shape?
  const Vec3& a = this->X(c[0]);
  const double longest2 = std::max(Norm2(this->X(c[1]) - a), Norm2(this->X(c[2]) - a));
  const double away2 = Norm2(this->X(p) - a);
  if (away2 > 2 * (this->Cutoff * this->Cutoff + longest2)) // at least the square of their sum
  {
    return;
  }
  Vec3 closest;
  std::array<double, 3> weights;
  const double distance2 =
    PointTriangleDistance2(this->X(p), this->X(c[0]), this->X(c[1]), this->X(c[2]), closest, weights);
  if (distance2 >= this->Cutoff * this->Cutoff)
  {
    return;
  }
  for (const Id s : Row(this->Star, p))
  {
    this->Note(s, t, distance2, this->X(p) - closest, this->X(p));
  }
}

void GapFinder::MeasurePair(Id s, Id t)
{
  const unsigned own = this->Owned[At(s)];
  const unsigned other = this->Owned[At(t)];
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (own & (8u << i))
    {
      this->MeasureCorner(this->Triangles[At(s)][i], t);
    }
    if (other & (8u << i))
    {
      this->MeasureCorner(this->Triangles[At(t)][i], s);
    }
    for (std::size_t j = 0; j < 3 && (own & (1u << i)); ++j)
    {
      if (other & (1u << j))
      {
        this->MeasureEdges(this->EdgesOf[At(s)][i], this->EdgesOf[At(t)][j]);
      }
    }
  }
}

void GapFinder::Measure(Monitor& monitor)
{
  this->Tree.ForPairs(this->Cutoff, monitor,
                      [&](Id s, Id t)
                      {
                        if ((this->Owned[At(s)] | this->Owned[At(t)]) != 0)
                        {
                          this->MeasurePair(s, t);
                        }
                      });
}

SheetGaps GapFinder::OfPoints() const
{
  SheetGaps gaps;
  gaps.any.assign(this->Points.size(), this->Cutoff);
  gaps.facing.assign(this->Points.size(), this->Cutoff);
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const double any = std::sqrt(this->Any.Of(static_cast<Id>(t)));
    const double facing = std::sqrt(this->Facing.Of(static_cast<Id>(t)));
    for (const Id p : this->Triangles[t])
    {
      gaps.any[At(p)] = std::min(gaps.any[At(p)], any);
      gaps.facing[At(p)] = std::min(gaps.facing[At(p)], facing);
    }
  }
  return gaps;
}

} // namespace

SheetGaps MeasureGaps(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                      const EdgeTable& table, const Lists& star, double cutoff, Monitor& monitor)
{
  GapFinder finder(points, triangles, table, star, cutoff);
  finder.Measure(monitor);
  return finder.OfPoints();
}

std::vector<double> MeasureTrueGaps(const TriangleComplex& surface, const EdgeTable& table, const Lists& star,
                                    const std::vector<double>& reaches, Monitor& monitor)
{
  const double cutoff = reaches.empty() ? 0 : *std::max_element(reaches.begin(), reaches.end());
  GapFinder finder(surface.points, surface.triangles, table, star, cutoff, &surface.materials);
  finder.Limit(reaches);
  finder.Measure(monitor);
  std::vector<double> gaps = finder.OfPoints().facing;
  std::transform(gaps.begin(), gaps.end(), reaches.begin(), gaps.begin(),
                 [](double gap, double reach) { return std::min(gap, reach); });
  return gaps;
}

} // namespace lamina
