// SPDX-License-Identifier: BSD-3-Clause
// Faces between cells made less oblique and less skew, for the sake of finite volumes.
#include "FrontCells.h"
#include "TetCavity.h"

#include "../Geometry/Quality.h"
#include "../Mesh/TetFaces.h"

#include <algorithm>
#include <limits>

namespace lamina
{
namespace
{

constexpr double WidestAngle = 85; ///< degrees
constexpr double MostSkew = 4;
/// A change must be worth its while.
constexpr double LeastGain = 1e-3;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

bool Has(const TetCavity::Tet& tet, Id point)
{
  return std::find(tet.begin(), tet.end(), point) != tet.end();
}

bool Has(const TetCavity::Tet& tet, const Triangle& face)
{
  return Has(tet, face[0]) && Has(tet, face[1]) && Has(tet, face[2]);
}

Vec3 CentreOf(const TetCavity::Tet& tet, const std::vector<Vec3>& p)
{
  return 0.25 * (p[Index(tet[0])] + p[Index(tet[1])] + p[Index(tet[2])] + p[Index(tet[3])]);
}

} // namespace

double FaceExcess(const std::array<Vec3, 3>& face, const Vec3& near, const Vec3& far)
{
  return std::max(FaceNonOrthogonality(face, near, far) / WidestAngle,
                  FaceSkewness(face, near, far) / MostSkew);
}

std::vector<TetCavity::Tet> TetCavity::CornersOf(const std::vector<Id>& tets) const
{
  std::vector<Tet> corners;
  std::transform(tets.begin(), tets.end(), std::back_inserter(corners),
                 [&](Id t) { return this->Set.tets[Index(t)]; });
  return corners;
}

/// Of the face towards another of `tets`, a tet that none of these stands for, or a prism; 0 if there is
/// none.
double TetCavity::ExcessOf(const Tet& tet, std::size_t opposite, const std::vector<Tet>& tets,
                           const std::vector<Id>& instead) const
{
  const auto& p = this->Set.points;
  const Triangle face = TetFace(tet, opposite);
  const std::array<Vec3, 3> places{ { p[Index(face[0])], p[Index(face[1])], p[Index(face[2])] } };
  const Vec3 own = CentreOf(tet, p);
  for (const Tet& other : tets)
  {
    if (!Has(other, tet[opposite]) && Has(other, face))
    {
      return FaceExcess(places, own, CentreOf(other, p));
    }
  }
  const auto known = std::find_if(face.begin(), face.end(), [&](Id c) { return this->IsKnown(c); });
  if (known != face.end())
  {
    for (Id t : this->TetsOf(*known))
    {
      const Tet& other = this->Set.tets[Index(t)];
      if (std::find(instead.begin(), instead.end(), t) == instead.end() && Has(other, face))
      {
        const bool isOneFluid = this->Set.groups[Index(t)] == this->Set.groups[Index(instead.front())];
        return isOneFluid ? FaceExcess(places, own, CentreOf(other, p)) : 0;
      }
    }
  }
  const Vec3* behind = this->Set.front != nullptr ? this->Set.front->CentreBehind(face) : nullptr;
  return behind != nullptr ? FaceExcess(places, own, *behind) : 0;
}

double TetCavity::WorstOf(const std::vector<Tet>& tets, const std::vector<Id>& instead) const
{
  double worst = 0;
  for (const Tet& tet : tets)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      worst = std::max(worst, this->ExcessOf(tet, k, tets, instead));
    }
  }
  return worst;
}

double TetCavity::WorstFace(Id tet) const
{
  return this->WorstOf({ this->Set.tets[Index(tet)] }, { tet });
}

/// Moves a point to where the worst face of its star is best.
bool TetCavity::MoveForFaces(Id point, double enough)
{
  const std::vector<Id> star = this->TetsOf(point);
  const std::vector<Tet> tets = this->CornersOf(star);
  Vec3& place = this->Set.points[Index(point)];
  const Vec3 start = place;
  const double asked = std::min(enough, this->LeastOf(star));
  double edge = std::numeric_limits<double>::infinity();
  for (const Tet& tet : tets)
  {
    for (Id p : tet)
    {
      edge = p == point ? edge : std::min(edge, Norm(this->Set.points[Index(p)] - start));
    }
  }
  const auto score = [&](const Vec3& to, double)
  {
    place = to;
    const bool isGood = this->LeastOf(star) >= asked;
    return isGood ? -this->WorstOf(tets, star) : -std::numeric_limits<double>::infinity();
  };
  const double before = score(start, 0);
  const Vec3 best = SearchBest(start, 0.2 * edge, score);
  if (score(best, 0) > before + LeastGain && this->IsSound(tets))
  {
    return true;
  }
  place = start;
  return false;
}

bool TetCavity::BetterFaces(Id tet, double enough)
{
  const Tet own = this->Set.tets[Index(tet)];
  Change best;
  double most = LeastGain;
  const auto consider = [&](Change&& change)
  {
    if (change.kind == Done::Nothing)
    {
      return;
    }
    const double gain =
      this->WorstOf(this->CornersOf(change.out), change.out) - this->WorstOf(change.in, change.out);
    if (gain > most)
    {
      most = gain;
      best = std::move(change);
    }
  };
  for (std::size_t i = 0; i < 4; ++i)
  {
    Change flipped;
    this->FlipFace(tet, i, flipped, enough);
    consider(std::move(flipped));
    for (std::size_t j = i + 1; j < 4; ++j)
    {
      Change removed;
      this->RemoveEdge(tet, own[i], own[j], removed, enough);
      consider(std::move(removed));
    }
  }
  if (best.kind != Done::Nothing)
  {
    this->Apply(best);
    return true;
  }
  bool hasMoved = false;
  for (Id p : own)
  {
    const bool isFree = this->Set.fixed[Index(p)] == 0 && this->IsKnown(p) && this->IsInterior(p);
    hasMoved = (isFree && this->MoveForFaces(p, enough)) || hasMoved;
  }
  return hasMoved;
}

} // namespace lamina
