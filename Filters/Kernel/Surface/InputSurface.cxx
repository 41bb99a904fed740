// SPDX-License-Identifier: BSD-3-Clause
#include "InputSurface.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

InputSurface::InputSurface(const TriangleComplex& surface, double tolerance)
  : Complex(surface)
  , Graph(MakeSheetGraph(Complex))
  , Mean(MeanEdgeLength(Complex))
  , Tolerance(tolerance)
{
  std::vector<std::vector<Id>> members(this->Graph.shellsOfSheet.size());
  for (std::size_t t = 0; t < this->Complex.triangles.size(); ++t)
  {
    members[static_cast<std::size_t>(this->Graph.sheetOfTriangle[t])].push_back(static_cast<Id>(t));
  }
  for (std::vector<Id>& subset : members)
  {
    this->Trees.push_back(
      std::make_unique<TriangleTree>(this->Complex.points, this->Complex.triangles, std::move(subset)));
  }
}

TriangleTree::Closest InputSurface::ClosestOnSheet(int sheet, const Vec3& p, double limit) const
{
  return this->Trees[static_cast<std::size_t>(sheet)]->ClosestPoint(p, limit * limit);
}

bool InputSurface::IsNear(int sheet, const Vec3& p, double least) const
{
  const double widest = std::max(least, this->Tolerance > 0 ? this->Tolerance : 0.5 * this->Mean);
  const TriangleTree::Closest place = this->ClosestOnSheet(sheet, p, widest);
  if (place.triangle < 0)
  {
    return false;
  }
  if (this->Tolerance > 0 || this->Complex.featureSize.empty())
  {
    return true;
  }
  // A tenth of a mean edge is always allowed, else nothing could ever move in the narrowest places.
  const double local =
    std::max({ least, 0.1 * this->Interpolate(this->Complex.featureSize, place), 0.1 * this->Mean });
  return place.distance2 <= local * local;
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
