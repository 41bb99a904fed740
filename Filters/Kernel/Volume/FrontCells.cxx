// SPDX-License-Identifier: BSD-3-Clause
#include "FrontCells.h"

#include "../Geometry/Quality.h"
#include "../Mesh/Adjacency.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

namespace
{

/// Makes 8 degrees from the face's plane count as much as a dihedral angle of 8 degrees does (ShapeOfTet).
constexpr double CosineWeight = 1.44;
/// A lack of fit counts no more than this, so that no sliver is kept for its sake.
constexpr double LeastFit = 0.1;
/// Triangles whose points have layers but that no prism stands behind (they close a plane opening) have all
/// sides in their plane.
constexpr double LeastPrism = 1e-9;

/// Volume of a tet of 3r/R 0.13 on an equilateral triangle, over twice that triangle's area to the power 1.5:
/// it is 0.127 edges high.
constexpr double LowestTet = 0.0227;

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

/// 0.25 at 0.5 and 2, 0.22 at 0.3 and 3, and never below 0.12.
double WorthOfRatio(double ratio)
{
  if (ratio > 2)
  {
    return ratio < 3 ? 0.25 - 0.03 * (ratio - 2) : 0.12 + 0.3 / ratio;
  }
  if (ratio < 0.5)
  {
    return ratio > 0.3 ? 0.22 + 0.15 * (ratio - 0.3) : 0.12 + 0.1 * std::max(0.0, ratio) / 0.3;
  }
  return 1;
}

/// The centre of mass, by three tets: where the columns' heights differ it stands off the nodes' mean.
Vec3 CentreOf(const std::array<Vec3, 6>& p)
{
  constexpr std::size_t tets[3][4] = { { 0, 1, 2, 3 }, { 1, 2, 3, 4 }, { 2, 3, 4, 5 } };
  Vec3 centre;
  double whole = 0;
  for (const auto& t : tets)
  {
    const double volume = std::abs(TetVolume(p[t[0]], p[t[1]], p[t[2]], p[t[3]]));
    centre += (0.25 * volume) * (p[t[0]] + p[t[1]] + p[t[2]] + p[t[3]]);
    whole += volume;
  }
  return whole > 0 ? centre * (1 / whole) : p[0];
}

} // namespace

FrontCells::FrontCells(const TriangleComplex& front)
  : Table(front.triangles, static_cast<Id>(front.points.size()))
{
  if (front.layerSide.size() != front.points.size())
  {
    return;
  }
  this->PointCount = static_cast<Id>(front.points.size());
  for (const Triangle& t : front.triangles)
  {
    std::array<Vec3, 6> nodes;
    bool hasPrism = true;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vec3& side = front.layerSide[U(t[k])];
      hasPrism = hasPrism && !(side == Vec3{});
      nodes[k] = front.points[U(t[k])] - side;
      nodes[k + 3] = front.points[U(t[k])];
    }
    Prism prism;
    prism.centre = CentreOf(nodes);
    const double size = std::pow(Norm(AreaVector2(front.points, t)), 1.5);
    const double volume = std::abs(WedgeVolume(nodes));
    prism.volume = hasPrism && volume > LeastPrism * size ? volume : 0;
    this->Prisms.push_back(prism);
  }
}

const FrontCells::Prism* FrontCells::Behind(const Triangle& face) const
{
  if (!this->IsOnFront(face[0]) || !this->IsOnFront(face[1]) || !this->IsOnFront(face[2]))
  {
    return nullptr;
  }
  const Id found = this->Table.Find(face);
  return found >= 0 && this->Prisms[U(found)].volume > 0 ? &this->Prisms[U(found)] : nullptr;
}

const Vec3* FrontCells::CentreBehind(const Triangle& face) const
{
  const Prism* behind = this->Behind(face);
  return behind != nullptr ? &behind->centre : nullptr;
}

double FrontCells::FitOver(const Triangle& face, const std::vector<Vec3>& points, const Vec3& apex) const
{
  const Prism* behind = this->Behind(face);
  if (behind == nullptr)
  {
    return 1;
  }
  const Prism& prism = *behind;
  const Vec3& a = points[U(face[0])];
  const Vec3 area = Cross(points[U(face[1])] - a, points[U(face[2])] - a);
  const Vec3 middle = 0.25 * (a + points[U(face[1])] + points[U(face[2])] + apex);
  const Vec3 line = middle - prism.centre;
  const double norms = Norm(line) * Norm(area);
  const double cosine = norms > 0 ? std::abs(Dot(line, area)) / norms : 0;
  const double upright = std::clamp(CosineWeight * cosine, LeastFit, 1.0);
  // On prisms this low no tet of three times their volume could be well shaped: they ask for none.
  const double lowest = LowestTet * std::pow(Norm(area), 1.5);
  const double volume = std::abs(Dot(apex - a, area)) / 6;
  return 3 * prism.volume < lowest ? upright : std::min(upright, WorthOfRatio(volume / prism.volume));
}

double FrontCells::FitOf(const std::array<Id, 4>& tet, const std::vector<Vec3>& points) const
{
  const auto inside = std::count_if(tet.begin(), tet.end(), [&](Id p) { return !this->IsOnFront(p); });
  double least = 1;
  for (std::size_t k = 0; k < 4 && inside < 2; ++k)
  {
    least = std::min(least, this->FitOver(TetFace(tet, k), points, points[U(tet[k])]));
  }
  return least;
}

} // namespace lamina
