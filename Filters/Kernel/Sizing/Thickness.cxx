// SPDX-License-Identifier: BSD-3-Clause
#include "Thickness.h"

#include "../Search/TriangleTree.h"

#include <algorithm>
#include <limits>

namespace lamina
{
namespace
{

constexpr Id Grain = 512;
constexpr double Pi = 3.14159265358979323846;
/// Hits nearer than this share of the edges around the point are rounding.
constexpr double NearestHit = 1e-3;
/// Cosine between a ray and the normal of a wall that it leaves through: flatter hits are grazes.
constexpr double LeastIncidence = 0.2;
/// Sine of the angle below which a ray runs in a plane patch and not through it.
constexpr double AlongPlane = 1e-6;
constexpr double NoWall = -1;

bool Touches(const MaterialPair& pair, int material)
{
  return pair.first == material || pair.second == material;
}

/// All that the rays of one material need.
class Caster
{
public:
  Caster(const TriangleComplex& surface, const Lists& star, int material, double maximum, double coneAngle)
    : Surface(surface)
    , Star(star)
    , Material(material)
    , Maximum(maximum)
    , Cosine(std::cos(coneAngle * Pi / 180))
    , Sine(std::sin(coneAngle * Pi / 180))
    , Boundary(surface.points, surface.triangles, BoundaryOf(surface, material))
  {
  }

  double At(Id point) const
  {
    const Vec3 inward = this->Inward(point);
    if (Norm2(inward) == 0)
    {
      return this->Maximum;
    }
    // Any pair of directions across the normal does; the axis least along it makes the first.
    const Vec3 a{ std::abs(inward.x), std::abs(inward.y), std::abs(inward.z) };
    const Vec3 axis =
      a.x <= a.y && a.x <= a.z ? Vec3{ 1, 0, 0 } : (a.y <= a.z ? Vec3{ 0, 1, 0 } : Vec3{ 0, 0, 1 });
    const Vec3 u = Normalized(Cross(inward, axis));
    const Vec3 v = Cross(inward, u);
    const double nearest = NearestHit * this->EdgeLength(point);
    std::array<double, 7> found;
    found.fill(std::numeric_limits<double>::infinity());
    std::size_t count = 0;
    const auto cast = [&](const Vec3& direction, double cosine)
    {
      const double diameter = this->Diameter(point, direction, cosine, nearest);
      if (diameter != NoWall)
      {
        found[count++] = diameter;
      }
    };
    cast(inward, 1);
    for (int k = 0; k < 6 && this->Sine > 0; ++k)
    {
      const double turn = k * Pi / 3;
      const Vec3 across = std::cos(turn) * u + std::sin(turn) * v;
      cast(this->Cosine * inward + this->Sine * across, this->Cosine);
    }
    if (count == 0)
    {
      return this->Maximum;
    }
    // Where walls are smooth the rays differ by cos^2 of the cone's angle at most (in a slab) and the least
    // is the truth. On a rough surface one may graze a bump next to the point: it is known by its distance to
    // the median.
    std::sort(found.begin(), found.end());
    const double graze = 0.9 * this->Cosine * this->Cosine * found[count / 2];
    return *std::lower_bound(found.begin(), found.end(), graze);
  }

private:
  static std::vector<Id> BoundaryOf(const TriangleComplex& surface, int material)
  {
    std::vector<Id> boundary;
    for (Id t = 0; t < static_cast<Id>(surface.triangles.size()); ++t)
    {
      if (Touches(surface.materials[static_cast<std::size_t>(t)], material))
      {
        boundary.push_back(t);
      }
    }
    return boundary;
  }

  const Vec3& Corner(Id triangle, std::size_t k) const
  {
    return this->Surface
      .points[static_cast<std::size_t>(this->Surface.triangles[static_cast<std::size_t>(triangle)][k])];
  }

  /// Along the normal out of the material, twice the area long.
  Vec3 Outward(Id triangle) const
  {
    const Vec3 n =
      AreaVector2(this->Surface.points, this->Surface.triangles[static_cast<std::size_t>(triangle)]);
    return this->Surface.materials[static_cast<std::size_t>(triangle)].first == this->Material ? n : -n;
  }

  template<typename Visit>
  void ForTriangles(Id point, Visit&& visit) const
  {
    for (Id t : Row(this->Star, point))
    {
      if (Touches(this->Surface.materials[static_cast<std::size_t>(t)], this->Material))
      {
        visit(t);
      }
    }
  }

  /// Unit normal into the material, each wall triangle weighted by its angle at the point; zero where the
  /// point lies on plane patches alone, which are no walls.
  Vec3 Inward(Id point) const
  {
    Vec3 sum;
    this->ForTriangles(point,
                       [&](Id t)
                       {
                         if (this->Surface.Patch(t) != 0)
                         {
                           return;
                         }
                         const Triangle& c = this->Surface.triangles[static_cast<std::size_t>(t)];
                         const std::size_t k = c[0] == point ? 0 : (c[1] == point ? 1 : 2);
                         const Vec3 e = this->Corner(t, (k + 1) % 3) - this->Corner(t, k);
                         const Vec3 f = this->Corner(t, (k + 2) % 3) - this->Corner(t, k);
                         const double angle = std::atan2(Norm(Cross(e, f)), Dot(e, f));
                         sum -= angle * Normalized(this->Outward(t));
                       });
    return Normalized(sum);
  }

  double EdgeLength(Id point) const
  {
    double sum = 0;
    int count = 0;
    this->ForTriangles(point,
                       [&](Id t)
                       {
                         for (std::size_t k = 0; k < 3; ++k)
                         {
                           sum += Norm(this->Corner(t, (k + 1) % 3) - this->Corner(t, k));
                           ++count;
                         }
                       });
    return sum / count;
  }

  /// True if a ray from the point leaves the material through a plane patch right there.
  bool LeavesAtOnce(Id point, const Vec3& direction) const
  {
    const ListRow row = Row(this->Star, point);
    return !this->Surface.patches.empty() &&
           std::any_of(row.begin(), row.end(),
                       [&](Id t)
                       {
                         return this->Surface.Patch(t) != 0 &&
                                Touches(this->Surface.materials[static_cast<std::size_t>(t)],
                                        this->Material) &&
                                Dot(direction, Normalized(this->Outward(t))) > AlongPlane;
                       });
  }

  /// Diameter of the ball tangent at the point through the ray's exit, at most the maximum; NoWall where the
  /// ray leaves through a plane patch.
  double Diameter(Id point, const Vec3& direction, double cosine, double nearest) const
  {
    if (this->LeavesAtOnce(point, direction))
    {
      return NoWall;
    }
    const auto leaves = [&](Id t)
    {
      const Triangle& c = this->Surface.triangles[static_cast<std::size_t>(t)];
      return c[0] != point && c[1] != point && c[2] != point &&
             Dot(direction, Normalized(this->Outward(t))) > LeastIncidence;
    };
    const auto hit = this->Boundary.FirstHit(this->Surface.points[static_cast<std::size_t>(point)], direction,
                                             nearest, this->Maximum * cosine, leaves);
    if (hit.triangle >= 0 && this->Surface.Patch(hit.triangle) != 0)
    {
      return NoWall;
    }
    return hit.triangle < 0 ? this->Maximum : std::min(this->Maximum, hit.t / cosine);
  }

  const TriangleComplex& Surface;
  const Lists& Star;
  int Material;
  double Maximum;
  double Cosine;
  double Sine;
  TriangleTree Boundary;
};

} // namespace

std::vector<Id> PointsOfMaterial(const TriangleComplex& surface, int material)
{
  std::vector<char> touched(surface.points.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (Touches(surface.materials[t], material))
    {
      for (Id p : surface.triangles[t])
      {
        touched[static_cast<std::size_t>(p)] = 1;
      }
    }
  }
  std::vector<Id> ids;
  for (std::size_t p = 0; p < touched.size(); ++p)
  {
    if (touched[p] != 0)
    {
      ids.push_back(static_cast<Id>(p));
    }
  }
  return ids;
}

std::vector<double> MeasureThickness(const TriangleComplex& surface, const Lists& star, int material,
                                     const std::vector<Id>& ids, double maximum, double coneAngle,
                                     Monitor& monitor)
{
  const Caster caster(surface, star, material, maximum, coneAngle);
  std::vector<double> thickness(ids.size(), maximum);
  monitor.For(static_cast<Id>(ids.size()), Grain,
              [&](Id begin, Id end)
              {
                for (Id i = begin; i < end; ++i)
                {
                  thickness[static_cast<std::size_t>(i)] = caster.At(ids[static_cast<std::size_t>(i)]);
                }
              });
  return thickness;
}

} // namespace lamina
