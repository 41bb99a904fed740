// SPDX-License-Identifier: BSD-3-Clause
#include "CutPlacement.h"

#include "../Mesh/EdgeAngles.h"
#include "../Search/SelfIntersection.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

namespace
{

constexpr double leastCosine = 0.25;    ///< between the normals of a triangle before and after
constexpr double leastArea = 0.1;       ///< of a triangle, against before
constexpr double greatestCosine = 0.94; ///< between triangles at an edge: 20 degrees
constexpr int halvings = 4;

std::size_t At(Id i)
{
  return static_cast<std::size_t>(i);
}

/// The volume that a triangle sweeps along its normal while its corners go straight from `a` to `b`: exact,
/// as its area vector is of second degree on the way.
double SweptVolume(const Triangle& t, const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
  Vec3 move;
  for (const Id p : t)
  {
    move += (1.0 / 3) * (b[At(p)] - a[At(p)]);
  }
  const auto area2 = [&](double s)
  {
    const auto x = [&](std::size_t k) { return a[At(t[k])] + s * (b[At(t[k])] - a[At(t[k])]); };
    return Cross(x(1) - x(0), x(2) - x(0));
  };
  return Dot(move, (1.0 / 12) * (area2(0) + 4 * area2(0.5) + area2(1)));
}

/// Moves points as far as no triangle suffers.
class CutPlacement
{
public:
  CutPlacement(const GridGeometry& grid, const std::vector<VoxelFace>& faces,
               const std::vector<GreyCut>& cuts, TriangleComplex& surface)
    : Faces(faces)
    , Cuts(cuts)
    , Surface(surface)
    , Start(surface.points)
    , Spacing(grid.spacing)
    , Table(MakeEdgeTable(surface.triangles))
  {
    const Vec3 zero = grid.ToWorld(0, 0, 0);
    this->Axes = { { grid.ToWorld(1, 0, 0) - zero, grid.ToWorld(0, 1, 0) - zero,
                     grid.ToWorld(0, 0, 1) - zero } };
    this->FindMoves();
  }
  GreyCutsReport Run(Monitor& monitor);

private:
  void FindMoves();
  std::array<Id, 4> CornersOf(std::size_t face) const;
  Vec3 AlongAxes(const Vec3& v) const
  {
    return { Dot(v, this->Axes[0]) / this->Spacing.x, Dot(v, this->Axes[1]) / this->Spacing.y,
             Dot(v, this->Axes[2]) / this->Spacing.z };
  }
  void Move();
  std::vector<Id> Suffering(Monitor& monitor) const;

  const std::vector<VoxelFace>& Faces;
  const std::vector<GreyCut>& Cuts;
  TriangleComplex& Surface;
  std::vector<Vec3> Start;
  Vec3 Spacing;
  EdgeTable Table;
  std::array<Vec3, 3> Axes; ///< from voxel to voxel
  std::vector<Vec3> Moves;
  std::vector<Vec3> Asked;           ///< where the points would be without bounds
  std::vector<unsigned char> Halved; ///< how often, a point
};

void CutPlacement::FindMoves()
{
  const std::size_t count = this->Start.size();
  std::vector<int> known(count, 0);
  std::vector<std::array<bool, 3>> stays(count, { { false, false, false } });
  this->Moves.assign(count, Vec3{});
  this->Asked = this->Start;
  this->Halved.assign(count, 0);
  for (std::size_t f = 0; f < this->Faces.size(); ++f)
  {
    const VoxelFace& face = this->Faces[f];
    const GreyCut& cut = this->Cuts[f];
    const std::array<Id, 4> corners = this->CornersOf(f);
    const Vec3 middle = 0.5 * (this->Start[At(corners[1])] + this->Start[At(corners[2])]);
    for (const Id p : corners)
    {
      // To the plane through the cut, not by the cut's way: the corners of steps stand farther off.
      const Vec3 toMiddle = this->AlongAxes(middle - this->Start[At(p)]);
      const double toCut = cut.offset * this->Spacing[face.axis] * cut.normal[face.axis];
      const double distance = cut.known ? toCut + Dot(toMiddle, cut.normal) : 0;
      this->Moves[At(p)] += distance * cut.normal;
      known[At(p)] += cut.known ? 1 : 0;
      stays[At(p)][static_cast<std::size_t>(face.axis)] |= !face.MayMove();
    }
  }
  for (std::size_t p = 0; p < count; ++p)
  {
    Vec3 move;
    for (int c = 0; c < 3 && known[p] > 0; ++c)
    {
      const bool mayMove = !stays[p][static_cast<std::size_t>(c)];
      const double voxels = mayMove ? this->Moves[p][c] / known[p] / this->Spacing[c] : 0;
      const Vec3& axis = this->Axes[static_cast<std::size_t>(c)];
      move += std::clamp(voxels, -LargestCutMove, LargestCutMove) * axis;
      this->Asked[p] += std::clamp(voxels, -1.0, 1.0) * axis;
    }
    this->Moves[p] = move;
  }
}

/// The four points of a face, the two that its diagonal joins in the middle.
std::array<Id, 4> CutPlacement::CornersOf(std::size_t face) const
{
  const Triangle& s = this->Surface.triangles[2 * face];
  const Triangle& t = this->Surface.triangles[2 * face + 1];
  const auto fourth =
    std::find_if(t.begin(), t.end(), [&](Id p) { return p != s[0] && p != s[1] && p != s[2]; });
  const auto shared = [&](Id p) { return std::find(t.begin(), t.end(), p) != t.end(); };
  const auto lone = std::find_if(s.begin(), s.end(), [&](Id p) { return !shared(p); });
  const std::size_t at = static_cast<std::size_t>(lone - s.begin());
  return { { *lone, s[(at + 1) % 3], s[(at + 2) % 3], *fourth } };
}

void CutPlacement::Move()
{
  for (std::size_t p = 0; p < this->Start.size(); ++p)
  {
    const int times = this->Halved[p];
    this->Surface.points[p] =
      times > halvings ? this->Start[p] : this->Start[p] + std::ldexp(1.0, -times) * this->Moves[p];
  }
}

/// Points of triangles that turned over, shrank, closed on a neighbour or met another.
std::vector<Id> CutPlacement::Suffering(Monitor& monitor) const
{
  const std::vector<Vec3>& points = this->Surface.points;
  const std::vector<Triangle>& triangles = this->Surface.triangles;
  std::vector<char> bad(triangles.size(), 0);
  monitor.For(static_cast<Id>(triangles.size()), 8192,
              [&](Id begin, Id end)
              {
                for (Id t = begin; t < end; ++t)
                {
                  const Vec3 before = AreaVector2(this->Start, triangles[At(t)]);
                  const Vec3 now = AreaVector2(points, triangles[At(t)]);
                  bad[At(t)] = Dot(before, now) < leastCosine * Norm(before) * Norm(now) ||
                               Norm(now) < leastArea * Norm(before);
                }
              });
  for (std::size_t e = 0; e < this->Table.edges.size(); ++e)
  {
    const ListRow row = Row(this->Table.triangles, static_cast<Id>(e));
    for (const Id* s = row.first; s != row.last; ++s)
    {
      for (const Id* t = s + 1; t != row.last; ++t)
      {
        if (CosineAtEdge(points, triangles, this->Table.edges[e], *s, *t) > greatestCosine)
        {
          bad[At(*s)] = bad[At(*t)] = 1;
        }
      }
    }
  }
  for (const auto& pair : FindIntersections(points, triangles, monitor))
  {
    bad[At(pair[0])] = bad[At(pair[1])] = 1;
  }
  std::vector<Id> suffering;
  for (std::size_t t = 0; t < bad.size(); ++t)
  {
    for (const Id p : triangles[t])
    {
      if (bad[t] && this->Halved[At(p)] <= halvings && !(points[At(p)] == this->Start[At(p)]))
      {
        suffering.push_back(p);
      }
    }
  }
  std::sort(suffering.begin(), suffering.end());
  suffering.erase(std::unique(suffering.begin(), suffering.end()), suffering.end());
  return suffering;
}

GreyCutsReport CutPlacement::Run(Monitor& monitor)
{
  GreyCutsReport report;
  // At the latest when all points of the places are where they began there is nothing to suffer from.
  for (;;)
  {
    this->Move();
    const std::vector<Id> suffering = this->Suffering(monitor);
    if (suffering.empty() || monitor.Cancelled())
    {
      break;
    }
    for (const Id p : suffering)
    {
      ++this->Halved[At(p)];
    }
  }
  if (monitor.Cancelled())
  {
    this->Surface.points = this->Start;
    return report;
  }
  for (const Triangle& t : this->Surface.triangles)
  {
    report.growth.push_back(SweptVolume(t, this->Start, this->Asked));
  }
  for (std::size_t p = 0; p < this->Start.size(); ++p)
  {
    report.movedPoints += this->Surface.points[p] == this->Start[p] ? 0 : 1;
    report.heldPoints += this->Halved[p] > 0 ? 1 : 0;
  }
  return report;
}

} // namespace

GreyCutsReport PlaceAtGreyCuts(const GridGeometry& grid, const std::vector<VoxelFace>& faces,
                               const std::vector<GreyCut>& cuts, TriangleComplex& surface, Monitor& monitor)
{
  const std::vector<Vec3> start = surface.points;
  CutPlacement placement(grid, faces, cuts, surface);
  const GreyCutsReport report = placement.Run(monitor);
  if (monitor.Cancelled())
  {
    return report;
  }
  surface.missing.resize(surface.triangles.size(), { { 0, 0 } });
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const double area = 0.5 * Norm(AreaVector2(surface.points, surface.triangles[t]));
    const double rest = (report.growth[t] - SweptVolume(surface.triangles[t], start, surface.points)) /
                        (area * std::sqrt(area));
    surface.missing[t][0] += rest;
    surface.missing[t][1] -= rest;
  }
  return report;
}

} // namespace lamina
