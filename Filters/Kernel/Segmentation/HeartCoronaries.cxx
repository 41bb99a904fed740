// SPDX-License-Identifier: BSD-3-Clause
// The coronary trees of the phantom heart, laid out by angle around the ventricles and height.
#include "Distances.h"
#include "HeartShape.h"

#include <cmath>

namespace lamina
{

namespace
{

/// Stations of a vessel: degrees around the ventricles' axis (0 left, 90 back, 180 right), height, unused.
using Path = std::vector<Vec3>;

/// The path with `pieces` straight pieces between each two stations.
Path Subdivided(const Path& path, int pieces)
{
  Path fine;
  for (std::size_t s = 0; s + 1 < path.size(); ++s)
  {
    for (int i = 0; i < pieces; ++i)
    {
      fine.push_back(path[s] + (path[s + 1] - path[s]) * (double(i) / pieces));
    }
  }
  fine.push_back(path.back());
  return fine;
}

} // namespace

/// Lay a vessel at `depth` below the outside of the ventricles; thinner the further it goes.
void HeartShape::AddVessel(const std::vector<Vec3>& path, double fromRadius, double toRadius, double depth,
                           int tree)
{
  const Path stations = Subdivided(path, 4);
  Path points;
  for (const Vec3& station : stations)
  {
    const double angle = station.x * 3.14159265358979323846 / 180;
    const Vec3 out{ std::cos(angle), std::sin(angle), 0 };
    const Vec3 axis{ 0, -1, station.y };
    // From outside inwards by bisection: the outermost crossing lies between the two.
    double far = 80;
    while (far > 0 && this->SampleChambers(axis + out * (far - 2)).heart > -depth)
    {
      far -= 2;
    }
    double near = far - 2;
    for (int i = 0; i < 20; ++i)
    {
      const double middle = 0.5 * (near + far);
      (this->SampleChambers(axis + out * middle).heart > -depth ? far : near) = middle;
    }
    points.push_back(axis + out * near);
  }
  const double pieces = static_cast<double>(points.size()) - 1;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const double a = fromRadius + (toRadius - fromRadius) * (i / pieces);
    const double b = fromRadius + (toRadius - fromRadius) * ((i + 1) / pieces);
    this->Coronaries.push_back({ points[i], points[i + 1], a, b, tree });
  }
}

void HeartShape::AddCoronaries()
{
  const double thin = 1.35 * this->Voxel;
  const double middle = std::max(1.9, thin);
  const double thick = std::max(2.5, thin);
  // Left: the descending artery with two diagonals, the circumflex with two marginals, deep in the thick
  // wall.
  const double deep = thick + this->AtLeast(2, 2);
  this->AddVessel({ { -62, 2, 0 }, { -56, -14, 0 }, { -52, -30, 0 }, { -48, -42, 0 } }, thick, thin, deep, 1);
  this->AddVessel({ { -56, -14, 0 }, { -38, -24, 0 }, { -24, -38, 0 } }, middle, thin, deep, 1);
  this->AddVessel({ { -62, 2, 0 }, { -35, 0, 0 }, { 0, -1, 0 }, { 35, -4, 0 } }, thick, middle, deep, 1);
  this->AddVessel({ { -12, -1, 0 }, { -6, -16, 0 }, { 0, -32, 0 } }, middle, thin, deep, 1);
  this->AddVessel({ { 35, -4, 0 }, { 40, -20, 0 }, { 38, -36, 0 } }, middle, thin, deep, 1);
  // Right: around the right ventricle, a marginal, and down the back; its wall is thin, so it bulges out.
  const double shallow = 0.3 * thick;
  this->AddVessel({ { 222, 0, 0 }, { 195, -2, 0 }, { 170, -3, 0 }, { 145, -4, 0 } }, thick, middle, shallow,
                  2);
  this->AddVessel({ { 195, -2, 0 }, { 202, -16, 0 }, { 210, -28, 0 } }, middle, thin, shallow, 2);
  this->AddVessel({ { 145, -4, 0 }, { 125, -18, 0 }, { 112, -34, 0 } }, middle, thin, shallow, 2);
}

} // namespace lamina
