// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeRelaxation.h"

#include <algorithm>
#include <vector>

namespace lamina
{

namespace
{

constexpr int mostMaterials = 8; ///< around one edge; two points have six directions, for seven materials

/// First-order change of six times a material's volume: by the first point, by the second, and the bilinear
/// part.
struct Gradient
{
  int material;
  Vec3 first;
  Vec3 second;
  Vec3 both;
};

struct Gradients
{
  std::array<Gradient, mostMaterials> list;
  int count = 0;

  Gradient* Of(int material)
  {
    for (int i = 0; i < this->count; ++i)
    {
      if (this->list[static_cast<std::size_t>(i)].material == material)
      {
        return &this->list[static_cast<std::size_t>(i)];
      }
    }
    if (this->count == mostMaterials)
    {
      return nullptr;
    }
    this->list[static_cast<std::size_t>(this->count)] = { material, {}, {}, {} };
    return &this->list[static_cast<std::size_t>(this->count++)];
  }
};

/// Adds the triangles at `p`; `other` is the edge's other end (or -1). Positions are taken relative to
/// `origin`.
bool AddStar(const SmoothingState& s, Id p, Id other, const Vec3& origin, bool isFirst, Gradients& gradients)
{
  for (Id t : Row(s.star, p))
  {
    const Triangle& tri = s.surface.triangles[static_cast<std::size_t>(t)];
    const std::size_t at = tri[0] == p ? 0 : (tri[1] == p ? 1 : 2);
    const Id q = tri[(at + 1) % 3];
    const Id r = tri[(at + 2) % 3];
    const Vec3 area = Cross(s.surface.points[static_cast<std::size_t>(q)] - origin,
                            s.surface.points[static_cast<std::size_t>(r)] - origin);
    const MaterialPair& pair = s.surface.materials[static_cast<std::size_t>(t)];
    for (int side = 0; side < 2; ++side)
    {
      Gradient* g = gradients.Of(side == 0 ? pair.first : pair.second);
      if (g == nullptr)
      {
        return false;
      }
      const double sign = side == 0 ? 1 : -1;
      (isFirst ? g->first : g->second) += sign * area;
      if (isFirst && q == other) // (p, other, r): bilinear in p and other
      {
        g->both += sign * (s.surface.points[static_cast<std::size_t>(r)] - origin);
      }
      else if (isFirst && r == other) // (p, q, other) = (other, p, q)
      {
        g->both -= sign * (s.surface.points[static_cast<std::size_t>(q)] - origin);
      }
    }
  }
  return true;
}

/// The move of least norm within `freedom` that meets g_i . c = r_i: Gram-Schmidt over the independent
/// conditions.
bool SolveTranslation(const Vec3* g, const double* r, int count, const Freedom& freedom, Vec3& c)
{
  Vec3 basis[3];
  double value[3];
  int rank = 0;
  double scale2 = 0;
  for (int i = 0; i < count; ++i)
  {
    scale2 = std::max(scale2, Norm2(g[i]));
  }
  c = {};
  for (int i = 0; i < count; ++i)
  {
    Vec3 v = freedom.Project(g[i]);
    double rest = r[i];
    for (int k = 0; k < rank; ++k)
    {
      const double along = Dot(v, basis[k]);
      v -= along * basis[k];
      rest -= along * value[k];
    }
    const double n2 = Norm2(v);
    if (n2 < 1e-4 * scale2)
    {
      // A condition that follows from the others up to rounding is met already; any other cannot be met well.
      if (std::abs(rest) > 1e-13 * std::pow(scale2, 0.75))
      {
        return false;
      }
      continue;
    }
    if (rank == freedom.dimensions)
    {
      return false;
    }
    const double n = std::sqrt(n2);
    basis[rank] = (1 / n) * v;
    value[rank] = rest / n;
    c += value[rank] * basis[rank];
    ++rank;
  }
  return true;
}

/// One linear condition on the moves of two points.
struct Condition
{
  Vec3 first;
  Vec3 second;
  double value;
};

/// The moves of least norm that meet all conditions; false if they contradict each other.
bool SolveBoth(std::vector<Condition> conditions, Vec3& moveA, Vec3& moveB)
{
  double scale2 = 0;
  for (const Condition& c : conditions)
  {
    scale2 = std::max(scale2, Norm2(c.first) + Norm2(c.second));
  }
  moveA = {};
  moveB = {};
  for (std::size_t i = 0; i < conditions.size(); ++i)
  {
    Condition& c = conditions[i];
    const double n2 = Norm2(c.first) + Norm2(c.second);
    if (n2 < 1e-4 * scale2)
    {
      if (std::abs(c.value) > 1e-13 * std::pow(scale2, 0.75))
      {
        return false;
      }
      continue;
    }
    moveA += (c.value / n2) * c.first;
    moveB += (c.value / n2) * c.second;
    for (std::size_t j = i + 1; j < conditions.size(); ++j)
    {
      const double along = (Dot(conditions[j].first, c.first) + Dot(conditions[j].second, c.second)) / n2;
      conditions[j].first -= along * c.first;
      conditions[j].second -= along * c.second;
      conditions[j].value -= along * c.value;
    }
  }
  return true;
}

/// Where no common translation restores all volumes, as on most curves of four materials: the two ends move
/// on their own, by Newton's method for the volumes, which are bilinear in both moves.
bool RestoreApart(const Gradients& gradients, const Freedom& freedom, Vec3& da, Vec3& db)
{
  constexpr int rounds = 6;
  for (int round = 0; round < rounds; ++round)
  {
    std::vector<Condition> conditions;
    double worst = 0;
    double scale2 = 0;
    for (int i = 0; i < gradients.count - 1; ++i)
    {
      const Gradient& m = gradients.list[static_cast<std::size_t>(i)];
      const double six = Dot(da, m.first) + Dot(db, m.second) + Dot(da, Cross(db, m.both));
      conditions.push_back({ freedom.Project(m.first + Cross(db, m.both)),
                             freedom.Project(m.second + Cross(m.both, da)), -six });
      worst = std::max(worst, std::abs(six));
      scale2 = std::max(scale2, Norm2(m.first) + Norm2(m.second));
    }
    if (worst <= 1e-15 * std::pow(scale2, 0.75))
    {
      return true;
    }
    Vec3 a;
    Vec3 b;
    if (!SolveBoth(std::move(conditions), a, b))
    {
      return false;
    }
    da += a;
    db += b;
  }
  return false;
}

/// The common case, a sheet between two materials: one condition, and the triangles' own orientation will do.
bool TranslateOnSheet(const SmoothingState& s, Id a, Id b, const Vec3& da, const Vec3& db, Vec3& c)
{
  const auto& x = s.surface.points;
  const Vec3 origin = x[static_cast<std::size_t>(a)];
  Vec3 areaA;
  Vec3 areaB;
  Vec3 both;
  for (Id t : Row(s.star, a))
  {
    const Triangle& tri = s.surface.triangles[static_cast<std::size_t>(t)];
    const std::size_t at = tri[0] == a ? 0 : (tri[1] == a ? 1 : 2);
    const Vec3 q = x[static_cast<std::size_t>(tri[(at + 1) % 3])] - origin;
    const Vec3 r = x[static_cast<std::size_t>(tri[(at + 2) % 3])] - origin;
    areaA += Cross(q, r);
    both += tri[(at + 1) % 3] == b ? r : (tri[(at + 2) % 3] == b ? -q : Vec3{});
  }
  for (Id t : Row(s.star, b))
  {
    const Triangle& tri = s.surface.triangles[static_cast<std::size_t>(t)];
    const std::size_t at = tri[0] == b ? 0 : (tri[1] == b ? 1 : 2);
    areaB += Cross(x[static_cast<std::size_t>(tri[(at + 1) % 3])] - origin,
                   x[static_cast<std::size_t>(tri[(at + 2) % 3])] - origin);
  }
  const Vec3 gradient = areaA + areaB + Cross(both, da - db);
  const double g2 = Norm2(gradient);
  if (g2 <= 1e-24 * (Norm2(areaA) + Norm2(areaB)))
  {
    return false;
  }
  c = (-(Dot(da, areaA) + Dot(db, areaB) + Dot(da, Cross(db, both))) / g2) * gradient;
  return true;
}

Vec3 RingSum(const SmoothingState& s, Id p, Id except, int& count)
{
  Vec3 sum;
  count = 0;
  for (Id q : Row(s.ring, p))
  {
    ++count;
    if (q != except)
    {
      sum += s.surface.points[static_cast<std::size_t>(q)];
    }
  }
  return sum;
}

/// The moves before volumes are restored.
void LaplacianMoves(const SmoothingState& s, Id a, Id b, Vec3& moveA, Vec3& moveB)
{
  const auto& x = s.surface.points;
  const Vec3& xa = x[static_cast<std::size_t>(a)];
  const auto& curveA = s.alongCurve[static_cast<std::size_t>(a)];
  if (b < 0)
  {
    int n = 0;
    const Vec3 mean =
      curveA[0] >= 0
        ? 0.5 * (x[static_cast<std::size_t>(curveA[0])] + x[static_cast<std::size_t>(curveA[1])])
        : RingSum(s, a, -1, n) * (1.0 / std::max<double>(1, static_cast<double>(s.ring.Count(a))));
    moveA = mean - xa;
    moveB = {};
    return;
  }
  const Vec3& xb = x[static_cast<std::size_t>(b)];
  const auto& curveB = s.alongCurve[static_cast<std::size_t>(b)];
  if (curveA[0] >= 0)
  {
    const Vec3& before = x[static_cast<std::size_t>(curveA[0] == b ? curveA[1] : curveA[0])];
    const Vec3& after = x[static_cast<std::size_t>(curveB[0] == a ? curveB[1] : curveB[0])];
    moveA = (1.0 / 3) * (2 * before + after) - xa;
    moveB = (1.0 / 3) * (before + 2 * after) - xb;
    return;
  }
  int na = 0;
  int nb = 0;
  const Vec3 sumA = RingSum(s, a, b, na);
  const Vec3 sumB = RingSum(s, b, a, nb);
  const Vec3 goalA = (1.0 / (static_cast<double>(na) * nb - 1)) * (sumB + static_cast<double>(nb) * sumA);
  const Vec3 goalB = (1.0 / nb) * (goalA + sumB);
  moveA = goalA - xa;
  moveB = goalB - xb;
}

} // namespace

bool RelaxEdge(const SmoothingState& s, Id a, Id b, double weight, Relaxation& relaxation)
{
  const Vec3 origin = s.surface.points[static_cast<std::size_t>(a)];
  const Freedom& freedom = s.freedom[static_cast<std::size_t>(a)];
  Vec3 da;
  Vec3 db;
  LaplacianMoves(s, a, b, da, db);
  da = freedom.Project(weight * da);
  db = freedom.Project(weight * db);
  // Inside a plane patch no move in the plane changes a volume.
  const unsigned char kindA = s.surface.junctionKind[static_cast<std::size_t>(a)];
  if (kindA == (JunctionSheet | JunctionInBorderPlane) &&
      (b < 0 || s.surface.junctionKind[static_cast<std::size_t>(b)] == kindA))
  {
    relaxation = { a, b, da, db };
    return true;
  }
  const unsigned char sheet = JunctionSheet;
  if (b >= 0 && s.surface.junctionKind[static_cast<std::size_t>(a)] == sheet &&
      s.surface.junctionKind[static_cast<std::size_t>(b)] == sheet)
  {
    Vec3 c;
    if (!TranslateOnSheet(s, a, b, da, db, c))
    {
      return false;
    }
    relaxation = { a, b, da + c, db + c };
    return true;
  }
  Gradients gradients;
  if (!AddStar(s, a, b, origin, true, gradients) || (b >= 0 && !AddStar(s, b, a, origin, false, gradients)))
  {
    return false;
  }
  // The volumes of all materials add up to a constant: the last condition follows from the others.
  Vec3 g[mostMaterials];
  double r[mostMaterials];
  const int conditions = gradients.count - 1;
  for (int i = 0; i < conditions; ++i)
  {
    const Gradient& m = gradients.list[static_cast<std::size_t>(i)];
    g[i] = m.first + m.second + Cross(m.both, da - db);
    r[i] = -(Dot(da, m.first) + Dot(db, m.second) + Dot(da, Cross(db, m.both)));
  }
  Vec3 c;
  if (!SolveTranslation(g, r, conditions, freedom, c))
  {
    if (b < 0 || !RestoreApart(gradients, freedom, da, db))
    {
      return false;
    }
    relaxation = { a, b, da, db };
    return true;
  }
  relaxation = { a, b, da + c, b >= 0 ? db + c : Vec3{} };
  return true;
}

} // namespace lamina
