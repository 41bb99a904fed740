// SPDX-License-Identifier: BSD-3-Clause
#include "FarPlaces.h"

#include <algorithm>

namespace lamina
{

namespace
{

constexpr int parts = 4; ///< of an edge between places that are looked at

/// The places of a triangle that are looked at: corners, three within each edge, three and the middle inside.
const std::vector<std::array<double, 3>>& Places()
{
  static const std::vector<std::array<double, 3>> places = []
  {
    std::vector<std::array<double, 3>> all{ { { 1 / 3.0, 1 / 3.0, 1 / 3.0 } } };
    for (int i = 0; i <= parts; ++i)
    {
      for (int j = 0; i + j <= parts; ++j)
      {
        all.push_back({ { static_cast<double>(i) / parts, static_cast<double>(j) / parts,
                          static_cast<double>(parts - i - j) / parts } });
      }
    }
    return all;
  }();
  return places;
}

Vec3 PlaceIn(const TriangleComplex& surface, Id t, const std::array<double, 3>& weights)
{
  const Triangle& c = surface.triangles[static_cast<std::size_t>(t)];
  const auto at = [&](std::size_t k) { return weights[k] * surface.points[static_cast<std::size_t>(c[k])]; };
  return at(0) + at(1) + at(2);
}

} // namespace

FarPlaces::FarPlaces(const TriangleComplex& surface, const SheetGraph& sheets, const InputSurface& input)
  : Surface(surface)
  , Sheets(sheets)
  , Input(input)
  , Trees(MakeSheetTrees(surface, sheets))
{
}

bool FarPlaces::IsFar(Id triangle) const
{
  const int sheet = this->Sheets.sheetOfTriangle[static_cast<std::size_t>(triangle)];
  Id hint = -1;
  return std::any_of(Places().begin(), Places().end(),
                     [&](const std::array<double, 3>& w)
                     {
                       return !this->Input.IsNear(sheet, PlaceIn(this->Surface, triangle, w), hint,
                                                  this->Input.WholeOverShare());
                     });
}

Id FarPlaces::FarFrom(Id inputTriangle) const
{
  const TriangleComplex& from = this->Input.Surface();
  const Triangle& c = from.triangles[static_cast<std::size_t>(inputTriangle)];
  const TriangleTree& tree = *this->Trees[static_cast<std::size_t>(this->Input.TriangleSheet(inputTriangle))];
  Id hint = -1;
  for (const std::array<double, 3>& w : Places())
  {
    const Vec3 x = PlaceIn(from, inputTriangle, w);
    const double tolerance = this->Input.WholeOverShare() *
                             (w[0] * this->Input.Tolerance(c[0]) + w[1] * this->Input.Tolerance(c[1]) +
                              w[2] * this->Input.Tolerance(c[2]));
    const double limit2 = tolerance * tolerance;
    const bool isNear = (hint >= 0 && tree.ClosestOnTriangle(hint, x).distance2 <= limit2) ||
                        tree.FindNear(x, limit2,
                                      [&](const TriangleTree::Closest& place)
                                      {
                                        hint = place.triangle;
                                        return true;
                                      });
    if (!isNear)
    {
      return tree.ClosestPoint(x).triangle;
    }
  }
  return -1;
}

std::vector<Id> FarPlaces::Find(Monitor& monitor)
{
  for (const auto& tree : this->Trees)
  {
    tree->Refit();
  }
  std::vector<char> isFar(this->Surface.triangles.size(), 0);
  monitor.For(static_cast<Id>(isFar.size()), 1024,
              [&](Id begin, Id end)
              {
                for (Id t = begin; t < end; ++t)
                {
                  isFar[static_cast<std::size_t>(t)] = this->IsFar(t) ? 1 : 0;
                }
              });
  std::vector<Id> farFrom(this->Input.Surface().triangles.size(), -1);
  monitor.For(static_cast<Id>(farFrom.size()), 1024,
              [&](Id begin, Id end)
              {
                for (Id t = begin; t < end; ++t)
                {
                  farFrom[static_cast<std::size_t>(t)] = this->FarFrom(t);
                }
              });
  for (Id t : farFrom)
  {
    if (t >= 0)
    {
      isFar[static_cast<std::size_t>(t)] = 1;
    }
  }
  std::vector<Id> found;
  for (std::size_t t = 0; t < isFar.size(); ++t)
  {
    if (isFar[t])
    {
      found.push_back(static_cast<Id>(t));
    }
  }
  return found;
}

} // namespace lamina
