// SPDX-License-Identifier: BSD-3-Clause
#include "InputSurface.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

namespace
{

constexpr double leastGap = 0.26; ///< in voxels: a quarter is promised, the rest is for correcting volumes
constexpr double voxelPerMeanEdge = 1.1; ///< at most, where smoothing has been
constexpr double mostMeanEdges = 4;      ///< that targets count where there are no voxels

double DefaultTolerance(const TriangleComplex& surface, std::size_t point, double mean)
{
  const double size = surface.featureSize.empty() ? 0 : surface.featureSize[point];
  return std::min(size > 0 ? 0.1 * size : 0.2 * surface.targetEdgeLength[point], 0.5 * mean);
}

} // namespace

SheetTrees MakeSheetTrees(const TriangleComplex& surface, const SheetGraph& sheets)
{
  std::vector<std::vector<Id>> members(sheets.shellsOfSheet.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    members[static_cast<std::size_t>(sheets.sheetOfTriangle[t])].push_back(static_cast<Id>(t));
  }
  SheetTrees trees;
  for (std::vector<Id>& subset : members)
  {
    trees.push_back(std::make_unique<TriangleTree>(surface.points, surface.triangles, std::move(subset)));
  }
  return trees;
}

InputSurface::InputSurface(const TriangleComplex& surface, double tolerance, double anisotropy,
                           Monitor& monitor, double share)
  : Complex(surface)
  , Graph(MakeSheetGraph(Complex))
  , Mean(MeanEdgeLength(Complex))
  , Widest(0)
  , Share(share)
{
  if (this->Complex.junctionKind.size() != this->Complex.points.size())
  {
    ClassifyJunctions(this->Complex);
  }
  for (std::size_t p = 0; p < this->Complex.points.size(); ++p)
  {
    this->Tolerances.push_back(share *
                               (tolerance > 0 ? tolerance : DefaultTolerance(this->Complex, p, this->Mean)));
    this->Widest = std::max(this->Widest, this->Tolerances.back());
  }
  if (anisotropy > 1)
  {
    this->PointStretches = FindStretches(this->Complex, anisotropy, monitor);
  }
  this->Trees = MakeSheetTrees(this->Complex, this->Graph);
}

void InputSurface::KeepGaps()
{
  const bool isSingle = MaterialsOf(this->Complex).size() == 1;
  this->WidestGap = leastGap * (isSingle ? mostMeanEdges : voxelPerMeanEdge) * this->Mean;
}

double InputSurface::LeastGap(double target) const
{
  return std::min(leastGap * target, this->WidestGap);
}

Vec3 InputSurface::Origin(int sheet, const Vec3& p) const
{
  return this->Trees[static_cast<std::size_t>(sheet)]->ClosestPoint(p).point;
}

TriangleTree::Closest InputSurface::ClosestOnSheet(int sheet, const Vec3& p, double limit) const
{
  return this->Trees[static_cast<std::size_t>(sheet)]->ClosestPoint(p, limit * limit);
}

double InputSurface::Tolerance(const TriangleTree::Closest& place) const
{
  const Triangle& t = this->Complex.triangles[static_cast<std::size_t>(place.triangle)];
  return place.weights[0] * this->Tolerance(t[0]) + place.weights[1] * this->Tolerance(t[1]) +
         place.weights[2] * this->Tolerance(t[2]);
}

bool InputSurface::IsWithin(const TriangleTree::Closest& place, double scale) const
{
  const double tolerance = scale * this->Tolerance(place);
  return place.distance2 <= tolerance * tolerance;
}

std::vector<Id> InputSurface::TrianglesNear(int sheet, const Vec3& p, double distance) const
{
  std::vector<Id> near;
  this->Trees[static_cast<std::size_t>(sheet)]->FindNear(p, distance * distance,
                                                         [&](const TriangleTree::Closest& place)
                                                         {
                                                           near.push_back(place.triangle);
                                                           return false;
                                                         });
  std::sort(near.begin(), near.end());
  return near;
}

bool InputSurface::IsNear(int sheet, const Vec3& p, Id& hint, double scale) const
{
  const TriangleTree& tree = *this->Trees[static_cast<std::size_t>(sheet)];
  if (hint >= 0 && this->IsWithin(tree.ClosestOnTriangle(hint, p), scale))
  {
    return true;
  }
  return tree.FindNear(p, scale * scale * this->Widest * this->Widest,
                       [&](const TriangleTree::Closest& place)
                       {
                         const bool within = this->IsWithin(place, scale);
                         hint = within ? place.triangle : hint;
                         return within;
                       });
}

Vec3 InputSurface::InterpolateAxis(const std::vector<Vec3>& field, const TriangleTree::Closest& place) const
{
  const Triangle& t = this->Complex.triangles[static_cast<std::size_t>(place.triangle)];
  const auto weighted = [&](std::size_t k)
  { return 3 * place.weights[k] * field[static_cast<std::size_t>(t[k])]; };
  return MeanStretch(weighted(0), weighted(1), weighted(2));
}

double InputSurface::Interpolate(const std::vector<double>& field, const TriangleTree::Closest& place,
                                 std::size_t stride, std::size_t component) const
{
  const Triangle& t = this->Complex.triangles[static_cast<std::size_t>(place.triangle)];
  double sum = 0;
  double weight = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double value = field[static_cast<std::size_t>(t[k]) * stride + component];
    if (!std::isnan(value))
    {
      sum += (place.weights[k] + 1e-9) * value;
      weight += place.weights[k] + 1e-9;
    }
  }
  return weight > 0 ? sum / weight : std::nan("");
}

} // namespace lamina
