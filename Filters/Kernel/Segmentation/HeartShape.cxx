// SPDX-License-Identifier: BSD-3-Clause
// Heart units and axes: x to the patient's left, y to the back, z up along the left ventricle; the base lies
// at z = 8.
#include "HeartShape.h"
#include "Distances.h"

#include <cmath>

namespace lamina
{

namespace
{

constexpr double Far = 1e9;
constexpr double Pi = 3.14159265358979323846;

/// A funnel of two leaflets that hangs from a valve's ring into a ventricle.
struct Valve
{
  Vec3 ring;
  Vec3 tip;
  double ringRadius;
  double tipRadius;
  Vec3 cleft; ///< direction, across the axis, in which the leaflets part
};
const Valve Mitral{ { 14, 5, 9 }, { 12.5, 1, -7 }, 11.5, 6, { 0, 1, 0 } };
const Valve Tricuspid{ { -23, 6, 9 }, { -23, 0, -5 }, 11, 6, { 0, 1, 0 } };

/// A point on a valve's funnel: `along` 0 at the ring and 1 at the free edge; angle 0 is across the cleft.
Vec3 OnFunnel(const Valve& valve, double along, double angle)
{
  const Vec3 axis = Normalized(valve.tip - valve.ring);
  const Vec3 side = Normalized(Cross(valve.cleft, axis));
  const Vec3 front = Cross(axis, side);
  const double radius = valve.ringRadius + along * (valve.tipRadius - valve.ringRadius);
  return valve.ring + (valve.tip - valve.ring) * along +
         radius * (side * std::cos(angle) + front * std::sin(angle));
}

double LeafletDistance(const Vec3& p, const Valve& valve, double thickness, double gap)
{
  const Vec3 axis = valve.tip - valve.ring;
  const double length = Norm(axis);
  const Vec3 along = axis * (1 / length);
  const Vec3 q = p - valve.ring;
  const double t = Dot(q, along);
  const Vec3 across = q - along * t;
  const double slope = (valve.ringRadius - valve.tipRadius) / length;
  const double radius = valve.ringRadius - slope * std::min(length, std::max(t, -0.2 * length));
  const double sheet = std::abs(Norm(across) - radius) / std::sqrt(1 + slope * slope);
  const double beyond = std::max(t - length, -0.2 * length - t);
  const double body = std::sqrt(sheet * sheet + std::pow(std::max(beyond, 0.0), 2)) - 0.5 * thickness;
  const Vec3 side = Normalized(Cross(valve.cleft, along));
  return SmoothGreater(body, gap - std::abs(Dot(across, side)), 0.5 * gap);
}

} // namespace

HeartShape::HeartShape(double voxel, HeartLevel level, bool open)
  : Voxel(voxel)
  , Level(level)
  , Open(open)
{
  if (level == HeartLevel::Whole)
  {
    this->AddStrands();
    this->AddCoronaries();
  }
}

double HeartShape::AtLeast(double length, double voxels) const
{
  return std::max(length, voxels * this->Voxel);
}

void HeartShape::SampleLeft(const Vec3& p, Chambers& out) const
{
  // Alone, the ventricle is rounder, so that an image of a few voxels still has room for its blood.
  const bool alone = this->Level == HeartLevel::Single;
  const double ventricle =
    EllipsoidDistance(p, { 12, 0, -16 }, alone ? Vec3{ 27, 25, 31 } : Vec3{ 15, 15, 31 });
  const double thick = this->AtLeast(12, 2.6);
  out.left = ventricle;
  out.heart = ventricle - thick;
  if (this->Level < HeartLevel::Chambers)
  {
    return;
  }
  const double top = this->Open ? 200 : 50;
  const double vessel = this->AtLeast(3.5, 3);
  const double aorta = std::min(RodDistance(p, { 3, -9, 10 }, { 0, -12, 30 }, 7, 7),
                                RodDistance(p, { 0, -12, 30 }, { -4, -10, top }, 7, 7));
  double atrium = EllipsoidDistance(p, { 15, 14, 28 }, { 18, 14, 12 });
  atrium = SmoothLesser(atrium, RodDistance(p, { 13, 4, 4 }, { 14, 10, 24 }, 9, 9), 5);
  atrium = SmoothLesser(atrium, RodDistance(p, { 26, 20, 30 }, { 40, 26, 34 }, 4.5, 4), 4);
  atrium = SmoothLesser(atrium, RodDistance(p, { 28, 12, 31 }, { 41, 10, 38 }, 4.5, 4), 4);
  // Aorta and atrium meet in the ventricle only: above it a wall stands between them.
  const double apart = this->AtLeast(4, 4) * SmoothStep(8, 14, p.z);
  atrium = SmoothGreater(atrium, apart - aorta, 2);
  out.left = SmoothLesser(SmoothLesser(ventricle, atrium, 3), aorta, 3);
  out.heart = SmoothLesser(out.heart, atrium - this->AtLeast(4, 3), 5);
  out.heart = SmoothLesser(out.heart, aorta - vessel, 4);
}

void HeartShape::SampleRight(const Vec3& p, Chambers& out) const
{
  const double ventricle = EllipsoidDistance(p, { -12, -5, -13 }, { 25, 21, 31 });
  double right = ventricle;
  out.heart = SmoothLesser(out.heart, ventricle - this->AtLeast(5.5, 2.6), 5);
  double septum = this->AtLeast(8.5, 4);
  if (this->Level >= HeartLevel::Chambers)
  {
    const double top = this->Open ? 200 : 46;
    const double up = this->Open ? 200 : 52;
    const double artery = std::min(RodDistance(p, { -12, -22, 0 }, { -2, -28, 26 }, 7.5, 7),
                                   RodDistance(p, { -2, -28, 26 }, { 9, -26, top }, 7, 7));
    double atrium = EllipsoidDistance(p, { -19, 13, 26 }, { 22, 14, 14 });
    atrium = SmoothLesser(atrium, RodDistance(p, { -22, 6, 4 }, { -23, 10, 22 }, 9, 9), 5);
    const double vein = RodDistance(p, { -26, 14, 30 }, { -28, 13, up }, 5.5, 5.5);
    atrium = SmoothLesser(atrium, vein, 4);
    right = SmoothLesser(SmoothLesser(ventricle, atrium, 3), artery, 4);
    out.heart = SmoothLesser(out.heart, atrium - this->AtLeast(4, 3), 5);
    out.heart = SmoothLesser(out.heart, artery - this->AtLeast(3.5, 3), 4);
    septum = this->AtLeast(8.5 - 4.5 * SmoothStep(-10, 6, p.z), 4);
  }
  out.right = SmoothGreater(right, septum - out.left, 2);
}

HeartShape::Chambers HeartShape::SampleChambers(const Vec3& p) const
{
  Chambers out;
  this->SampleLeft(p, out);
  out.right = Far;
  if (this->Level > HeartLevel::Single)
  {
    this->SampleRight(p, out);
  }
  const double thin = this->AtLeast(3, 2.6);
  out.heart = std::min({ out.heart, out.left - thin, out.right - thin });
  return out;
}

double HeartShape::SampleLeaflets(const Vec3& p) const
{
  const double thickness = this->AtLeast(2.4, 2.6);
  const double gap = this->AtLeast(2.5, 2);
  return std::min(LeafletDistance(p, Mitral, thickness, gap), LeafletDistance(p, Tricuspid, thickness, gap));
}

HeartSample HeartShape::Sample(const Vec3& point, const Nearby& nearby) const
{
  Chambers chambers = this->SampleChambers(point);
  double vessel = Far;
  for (const TaperedRod& rod : nearby.coronaries)
  {
    vessel = std::min(vessel, RodDistance(point, rod.from, rod.to, rod.fromRadius, rod.toRadius));
  }
  if (!nearby.coronaries.empty())
  {
    // A coronary has its own sleeve of wall: it bulges out of a thin wall, and the chamber under it gives
    // way.
    chambers.heart = SmoothLesser(chambers.heart, vessel - 2.6 * this->Voxel, 3);
  }
  double chamber = std::min(chambers.left, chambers.right);
  const bool hollow = chamber < 0;
  HeartPart solid = HeartPart::Wall;
  if (this->Level == HeartLevel::Whole && chamber < 3 * this->Voxel)
  {
    const double leaflets = this->SampleLeaflets(point);
    double inside = leaflets;
    for (const TaperedRod& rod : nearby.strands)
    {
      inside = SmoothLesser(inside, RodDistance(point, rod.from, rod.to, rod.fromRadius, rod.toRadius),
                            1.2 * this->Voxel);
    }
    chamber = SmoothGreater(chamber, -inside, 2 * this->Voxel);
    if (hollow)
    {
      solid = inside < leaflets ? HeartPart::Strand : HeartPart::Leaflet;
    }
  }
  chamber = std::max(chamber, 4 * this->Voxel - vessel);
  HeartSample sample{ chambers.heart, std::min(chamber, vessel), HeartPart::Outside };
  if (sample.blood < 0)
  {
    sample.part = vessel < chamber ? HeartPart::Coronary : HeartPart::Chamber;
  }
  else if (sample.heart < 0)
  {
    sample.part = solid;
  }
  return sample;
}

HeartShape::Nearby HeartShape::Near(const Vec3& centre, double radius) const
{
  Nearby nearby;
  const auto collect = [&](const std::vector<TaperedRod>& rods, double reach, std::vector<TaperedRod>& found)
  {
    for (const TaperedRod& rod : rods)
    {
      if (RodDistance(centre, rod.from, rod.to, rod.fromRadius, rod.toRadius) < radius + reach)
      {
        found.push_back(rod);
      }
    }
  };
  collect(this->Coronaries, 8 * this->Voxel + 6, nearby.coronaries);
  collect(this->Strands, 6 * this->Voxel, nearby.strands);
  return nearby;
}

void HeartShape::Bounds(Vec3& least, Vec3& greatest) const
{
  // Open vessels end where closed ones would.
  HeartShape closed(*this);
  closed.Open = false;
  const auto heart = [&](const Vec3& p) { return closed.SampleChambers(p).heart; };
  least = { Far, Far, Far };
  greatest = { -Far, -Far, -Far };
  const auto include = [&](const Vec3& p, double reach)
  {
    for (int a = 0; a < 3; ++a)
    {
      least[a] = std::min(least[a], p[a] - reach);
      greatest[a] = std::max(greatest[a], p[a] + reach);
    }
  };
  constexpr double step = 4;
  constexpr double nudge = 0.01;
  const double reach = 70 + 3 * this->Voxel;
  for (double z = -reach; z < reach; z += step)
  {
    for (double y = -reach; y < reach; y += step)
    {
      for (double x = -reach; x < reach; x += step)
      {
        // Points near the surface are moved onto it: together they show how far it goes.
        const Vec3 p{ x, y, z };
        const double d = heart(p);
        if (std::abs(d) < step)
        {
          const Vec3 slope{ heart(p + Vec3{ nudge, 0, 0 }) - d, heart(p + Vec3{ 0, nudge, 0 }) - d,
                            heart(p + Vec3{ 0, 0, nudge }) - d };
          include(p - Normalized(slope) * d, 0.3);
        }
      }
    }
  }
  for (const TaperedRod& rod : this->Coronaries)
  {
    const double sleeve = std::max(rod.fromRadius, rod.toRadius) + 2.6 * this->Voxel;
    include(rod.from, sleeve);
    include(rod.to, sleeve);
  }
}

void HeartShape::AddStrands()
{
  const double cord = this->AtLeast(1.2, 1.3);
  const bool many = 1 / this->Voxel > 0.7;
  // Papillary muscles, each with the chordae from its tip to the free edges of both leaflets.
  const Vec3 tips[2] = { { 16, -7, -18 }, { 15, 8, -18 } };
  const Vec3 roots[2] = { { 24, -11, -34 }, { 22, 12, -34 } };
  for (int m = 0; m < 2; ++m)
  {
    this->Strands.push_back({ roots[m], tips[m], this->AtLeast(4.5, 1.6), this->AtLeast(3, 1.5), 0 });
    for (const double degrees : { 40.0, 140.0, 15.0, 165.0 })
    {
      if (many || degrees == 40.0 || degrees == 140.0)
      {
        const Vec3 edge = OnFunnel(Mitral, 0.95, (m == 0 ? -1 : 1) * degrees * Pi / 180);
        this->Strands.push_back({ tips[m], edge, cord, cord, 0 });
      }
    }
  }
  // A false tendon across the left ventricle and the moderator band across the right one.
  this->Strands.push_back({ { -6, 1, -26 }, { 30, -1, -31 }, cord, cord, 0 });
  this->Strands.push_back({ { -6, -8, -24 }, { -42, -9, -22 }, cord, cord, 0 });
}

} // namespace lamina
