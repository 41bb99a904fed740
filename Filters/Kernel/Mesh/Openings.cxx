// SPDX-License-Identifier: BSD-3-Clause
#include "Openings.h"
#include "Adjacency.h"

#include "../Base/Result.h"

#include <algorithm>
#include <map>

namespace lamina
{
namespace
{

/// How far from the plane a point counts as in it, in extents of the opening; and how well areas must agree.
constexpr double Tolerance = 1e-7;

Vec3 VectorArea(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return 0.5 * Cross(b - a, c - a);
}

} // namespace

Openings::Openings(const TriangleComplex* surface, double scale)
{
  std::map<std::pair<int, int>, std::size_t> known;
  for (std::size_t t = 0; surface != nullptr && t < surface->triangles.size(); ++t)
  {
    const int patch = surface->Patch(static_cast<Id>(t));
    if (!IsOpening(*surface, patch))
    {
      continue;
    }
    const int material = surface->materials[t].first;
    const auto [at, isNew] = known.emplace(std::pair<int, int>(patch, material), this->All.size());
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k] = surface->points[static_cast<std::size_t>(surface->triangles[t][k])] * scale;
    }
    if (isNew)
    {
      Opening opening;
      opening.patch = patch;
      opening.material = material;
      opening.origin = opening.low = opening.high = corners[0];
      this->All.push_back(opening);
    }
    Opening& opening = this->All[at->second];
    opening.area += VectorArea(corners[0], corners[1], corners[2]);
    for (const Vec3& corner : corners)
    {
      for (int k = 0; k < 3; ++k)
      {
        opening.low[k] = std::min(opening.low[k], corner[k]);
        opening.high[k] = std::max(opening.high[k], corner[k]);
      }
    }
  }
  for (Opening& opening : this->All)
  {
    opening.extent = Norm(opening.high - opening.low);
  }
}

int Openings::Locate(const VolumeMesh& mesh, const CellFace& face, int patch, Vec3& area) const
{
  const std::size_t n = face.IsQuad() ? 4 : 3;
  for (std::size_t o = 0; o < this->All.size(); ++o)
  {
    const Opening& opening = this->All[o];
    const Vec3 normal = Normalized(opening.area);
    const double near = Tolerance * opening.extent;
    bool isIn = mesh.materials[static_cast<std::size_t>(face.cell)] == opening.material &&
                (patch == 0 || patch == opening.patch);
    for (std::size_t i = 0; i < n && isIn; ++i)
    {
      const Vec3& p = mesh.points[static_cast<std::size_t>(face.corners[i])];
      isIn = std::abs(Dot(p - opening.origin, normal)) <= near;
      for (int k = 0; k < 3; ++k)
      {
        isIn = isIn && p[k] >= opening.low[k] - near && p[k] <= opening.high[k] + near;
      }
    }
    if (!isIn)
    {
      continue;
    }
    const auto corner = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(face.corners[i])]; };
    area = VectorArea(corner(0), corner(1), corner(2));
    area += n == 4 ? VectorArea(corner(0), corner(2), corner(3)) : Vec3{};
    if (Dot(area, normal) > 0)
    {
      return static_cast<int>(o);
    }
  }
  return -1;
}

bool Openings::Add(const VolumeMesh& mesh, const CellFace& face, int patch)
{
  Vec3 area;
  const int at = this->Locate(mesh, face, patch, area);
  if (at >= 0)
  {
    this->All[static_cast<std::size_t>(at)].covered += area;
  }
  return at >= 0;
}

int Openings::Find(const VolumeMesh& mesh, const CellFace& face, int patch) const
{
  Vec3 area;
  const int at = this->Locate(mesh, face, patch, area);
  return at >= 0 ? this->All[static_cast<std::size_t>(at)].patch : 0;
}

void Openings::Tell(std::vector<std::string>& findings) const
{
  for (const Opening& opening : this->All)
  {
    const double wanted = Norm(opening.area);
    const bool isMeshed = Norm2(opening.covered) > 0;
    if (isMeshed && Norm(opening.covered - opening.area) > Tolerance * wanted)
    {
      findings.push_back("opening " + std::to_string(opening.patch) + " of material " +
                         std::to_string(opening.material) + " is covered by faces of area " +
                         std::to_string(Norm(opening.covered)) + ", but has " + std::to_string(wanted) +
                         " at " + ToString(opening.origin));
    }
  }
}

} // namespace lamina
