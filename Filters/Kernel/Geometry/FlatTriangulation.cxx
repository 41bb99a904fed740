// SPDX-License-Identifier: BSD-3-Clause
#include "FlatTriangulation.h"

#include "Predicates.h"

#include <algorithm>
#include <limits>
#include <map>

namespace lamina
{
namespace
{

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

class Filler
{
public:
  Filler(std::vector<Vec2>& places, double spacing)
    : Places(places)
    , Spacing(spacing)
  {
  }

  std::vector<Triangle> Run(const FlatRegion& region)
  {
    std::vector<Id> ring = region.rim;
    std::vector<std::vector<Id>> holes = region.holes;
    // From right to left, so that what is right of a hole is joined already.
    const auto rightmost = [this](const std::vector<Id>& hole) {
      return *std::max_element(hole.begin(), hole.end(), [this](Id a, Id b) { return this->IsLeftOf(a, b); });
    };
    std::sort(holes.begin(), holes.end(),
              [&](const std::vector<Id>& a, const std::vector<Id>& b)
              { return this->IsLeftOf(rightmost(b), rightmost(a)); });
    for (std::size_t h = 0; h < holes.size(); ++h)
    {
      if (!this->Bridge(ring, holes, h, rightmost(holes[h])))
      {
        return {};
      }
    }
    if (!this->CutEars(ring))
    {
      return {};
    }
    this->Border(region);
    if (this->Spacing > 0)
    {
      this->AddPlaces(region);
    }
    this->Flip();
    return std::move(this->Triangles);
  }

private:
  bool IsLeftOf(Id a, Id b) const
  {
    const Vec2& p = this->Places[Index(a)];
    const Vec2& q = this->Places[Index(b)];
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  }
  int Turn(const Vec2& a, const Vec2& b, const Vec2& c) const
  {
    return Orientation({ a.x, a.y, 0 }, { b.x, b.y, 0 }, { c.x, c.y, 0 }, { a.x, a.y, 1 });
  }
  int Turn(Id a, Id b, Id c) const
  {
    return this->Turn(this->Places[Index(a)], this->Places[Index(b)], this->Places[Index(c)]);
  }
  double Distance2(const Vec2& a, const Vec2& b) const
  {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
  }

  /// True if the open segments cross, or an end of one lies on the other.
  bool Crosses(Id a, Id b, Id c, Id d) const
  {
    if (a == c || a == d || b == c || b == d)
    {
      return false;
    }
    const int c1 = this->Turn(a, b, c);
    const int d1 = this->Turn(a, b, d);
    const int a1 = this->Turn(c, d, a);
    const int b1 = this->Turn(c, d, b);
    if (c1 == 0 && d1 == 0)
    {
      return false; // in one line: told apart by the ends' own tests
    }
    return c1 * d1 <= 0 && a1 * b1 <= 0;
  }

  bool IsClear(Id from, Id to, const std::vector<Id>& ring) const
  {
    for (std::size_t k = 0; k < ring.size(); ++k)
    {
      if (this->Crosses(from, to, ring[k], ring[(k + 1) % ring.size()]))
      {
        return false;
      }
      // A place on the segment itself would be passed over.
      const Id p = ring[k];
      if (p != from && p != to && this->Turn(from, to, p) == 0 &&
          this->Distance2(this->Places[Index(from)], this->Places[Index(p)]) <
            this->Distance2(this->Places[Index(from)], this->Places[Index(to)]) &&
          this->Distance2(this->Places[Index(to)], this->Places[Index(p)]) <
            this->Distance2(this->Places[Index(from)], this->Places[Index(to)]))
      {
        return false;
      }
    }
    return true;
  }

  /// True if the way from ring[k] to p begins inside the region that the ring has on its left.
  bool LeavesInside(const std::vector<Id>& ring, std::size_t k, Id p) const
  {
    const Id before = ring[(k + ring.size() - 1) % ring.size()];
    const Id after = ring[(k + 1) % ring.size()];
    const int leftOfIn = this->Turn(before, ring[k], p);
    const int leftOfOut = this->Turn(ring[k], after, p);
    return this->Turn(before, ring[k], after) > 0 ? leftOfIn > 0 && leftOfOut > 0
                                                  : leftOfIn > 0 || leftOfOut > 0;
  }

  /// Join hole h to the ring by the shortest bridge from its rightmost place that nothing crosses.
  bool Bridge(std::vector<Id>& ring, const std::vector<std::vector<Id>>& holes, std::size_t h, Id from)
  {
    std::vector<std::size_t> order(ring.size());
    for (std::size_t k = 0; k < order.size(); ++k)
    {
      order[k] = k;
    }
    const auto away = [&](std::size_t k)
    { return this->Distance2(this->Places[Index(ring[k])], this->Places[Index(from)]); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return away(a) < away(b); });
    for (std::size_t k : order)
    {
      bool isClear =
        ring[k] != from && this->LeavesInside(ring, k, from) && this->IsClear(from, ring[k], ring);
      for (std::size_t other = h; isClear && other < holes.size(); ++other)
      {
        isClear = this->IsClear(from, ring[k], holes[other]);
      }
      if (!isClear)
      {
        continue;
      }
      std::vector<Id> turned = holes[h];
      std::rotate(turned.begin(), std::find(turned.begin(), turned.end(), from), turned.end());
      turned.push_back(from);
      turned.push_back(ring[k]);
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(k) + 1, turned.begin(), turned.end());
      return true;
    }
    return false;
  }

  bool IsEar(const std::vector<Id>& ring, std::size_t k) const
  {
    const Id a = ring[(k + ring.size() - 1) % ring.size()];
    const Id b = ring[k];
    const Id c = ring[(k + 1) % ring.size()];
    if (a == c || this->Turn(a, b, c) <= 0)
    {
      return false;
    }
    for (const Id p : ring)
    {
      if (p != a && p != b && p != c && this->Turn(a, b, p) >= 0 && this->Turn(b, c, p) >= 0 &&
          this->Turn(c, a, p) >= 0)
      {
        return false;
      }
    }
    return true;
  }

  bool CutEars(std::vector<Id> ring)
  {
    std::size_t at = 0;
    std::size_t misses = 0;
    while (ring.size() > 3)
    {
      at %= ring.size();
      if (this->IsEar(ring, at))
      {
        this->Triangles.push_back(
          { { ring[(at + ring.size() - 1) % ring.size()], ring[at], ring[(at + 1) % ring.size()] } });
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
        misses = 0;
        ++at; // not again beside the last ear, which would make a fan
      }
      else if (++misses > ring.size())
      {
        return false;
      }
      else
      {
        ++at;
      }
    }
    this->Triangles.push_back({ { ring[0], ring[1], ring[2] } });
    return this->Turn(ring[0], ring[1], ring[2]) > 0;
  }

  void Border(const FlatRegion& region)
  {
    const auto add = [this](const std::vector<Id>& ring)
    {
      for (std::size_t k = 0; k < ring.size(); ++k)
      {
        this->Rims.push_back({ { ring[k], ring[(k + 1) % ring.size()] } });
      }
    };
    add(region.rim);
    for (const std::vector<Id>& hole : region.holes)
    {
      add(hole);
    }
  }

  bool IsFarFromRims(const Vec2& p) const
  {
    const double near2 = 0.3 * this->Spacing * this->Spacing;
    return std::all_of(this->Rims.begin(), this->Rims.end(),
                       [&](const std::array<Id, 2>& e)
                       {
                         const Vec2& a = this->Places[Index(e[0])];
                         const Vec2& b = this->Places[Index(e[1])];
                         const double length2 = this->Distance2(a, b);
                         const double t = ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length2;
                         const double s = std::min(1.0, std::max(0.0, t));
                         return this->Distance2(p, { a.x + s * (b.x - a.x), a.y + s * (b.y - a.y) }) > near2;
                       });
  }

  /// Put places of a lattice of equal triangles inside, each into the triangle that it lies in.
  void AddPlaces(const FlatRegion& region)
  {
    Vec2 low = this->Places[Index(region.rim[0])];
    Vec2 high = low;
    for (const Id id : region.rim)
    {
      const Vec2& p = this->Places[Index(id)];
      low = { std::min(low.x, p.x), std::min(low.y, p.y) };
      high = { std::max(high.x, p.x), std::max(high.y, p.y) };
    }
    const double height = this->Spacing * std::sqrt(0.75);
    const auto rows = static_cast<Id>((high.y - low.y) / height);
    const auto columns = static_cast<Id>((high.x - low.x) / this->Spacing);
    for (Id row = 1; row <= rows; ++row)
    {
      for (Id column = 0; column <= columns; ++column)
      {
        const double shift = row % 2 == 0 ? 0.25 : 0.75;
        const Vec2 p{ low.x + (static_cast<double>(column) + shift) * this->Spacing,
                      low.y + (static_cast<double>(row) - 0.5) * height };
        if (this->IsFarFromRims(p))
        {
          this->Insert(p);
        }
      }
    }
  }

  void Insert(const Vec2& p)
  {
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      const Triangle corners = this->Triangles[t];
      const auto left = [&](std::size_t k) {
        return this->Turn(this->Places[Index(corners[k])], this->Places[Index(corners[(k + 1) % 3])], p) > 0;
      };
      if (left(0) && left(1) && left(2))
      {
        const Id id = static_cast<Id>(this->Places.size());
        this->Places.push_back(p);
        this->Triangles[t] = { { corners[0], corners[1], id } };
        this->Triangles.push_back({ { corners[1], corners[2], id } });
        this->Triangles.push_back({ { corners[2], corners[0], id } });
        return;
      }
    }
  }

  /// True if d lies in the circle through the corners of a triangle, by more than rounding.
  bool IsInCircle(Id a, Id b, Id c, Id d) const
  {
    const auto cosine = [&](Id apex)
    {
      const Vec2& o = this->Places[Index(apex)];
      const Vec2& p = this->Places[Index(a)];
      const Vec2& q = this->Places[Index(b)];
      return std::array<double, 2>{ { (p.x - o.x) * (q.x - o.x) + (p.y - o.y) * (q.y - o.y),
                                      std::abs((p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x)) } };
    };
    // Opposite angles over 180 degrees together.
    const auto m = cosine(c);
    const auto n = cosine(d);
    const double sine = m[1] * n[0] + m[0] * n[1];
    return sine < -1e-10 * (std::abs(m[1] * n[0]) + std::abs(m[0] * n[1]));
  }

  void Flip()
  {
    std::map<std::array<Id, 2>, std::size_t> triangleOf; // of each directed edge
    std::vector<std::array<Id, 2>> work;
    const auto enter = [&](std::size_t t)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::array<Id, 2> edge{ { this->Triangles[t][k], this->Triangles[t][(k + 1) % 3] } };
        triangleOf[edge] = t;
        work.push_back(edge);
      }
    };
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      enter(t);
    }
    const auto opposite = [&](std::size_t t, const std::array<Id, 2>& e)
    {
      const Triangle& c = this->Triangles[t];
      return c[0] != e[0] && c[0] != e[1] ? c[0] : (c[1] != e[0] && c[1] != e[1] ? c[1] : c[2]);
    };
    // Each flip lowers the triangulation in a fixed order; the bound is against rounding alone.
    std::size_t left = 100 * this->Triangles.size() + 1000;
    while (!work.empty() && left-- > 0)
    {
      const std::array<Id, 2> edge = work.back();
      work.pop_back();
      const auto own = triangleOf.find(edge);
      const auto other = triangleOf.find({ { edge[1], edge[0] } });
      if (own == triangleOf.end() || other == triangleOf.end())
      {
        continue;
      }
      const Id c = opposite(own->second, edge);
      const Id d = opposite(other->second, edge);
      if (!this->IsInCircle(edge[0], edge[1], c, d) || this->Turn(d, edge[1], c) <= 0 ||
          this->Turn(c, edge[0], d) <= 0 || triangleOf.count({ { c, d } }) != 0 ||
          triangleOf.count({ { d, c } }) != 0)
      {
        continue;
      }
      const std::size_t s = own->second;
      const std::size_t t = other->second;
      triangleOf.erase(own);
      triangleOf.erase({ { edge[1], edge[0] } });
      this->Triangles[s] = { { d, edge[1], c } };
      this->Triangles[t] = { { c, edge[0], d } };
      enter(s);
      enter(t);
    }
  }

  std::vector<Vec2>& Places;
  double Spacing;
  std::vector<Triangle> Triangles;
  std::vector<std::array<Id, 2>> Rims;
};

} // namespace

std::vector<Triangle> FillFlatRegion(std::vector<Vec2>& places, const FlatRegion& region, double spacing)
{
  return Filler(places, spacing).Run(region);
}

} // namespace lamina
