// SPDX-License-Identifier: BSD-3-Clause
#include "InputSamples.h"

#include "../Mesh/Adjacency.h"

#include <algorithm>

namespace lamina
{

InputSamples::InputSamples(const InputSurface& input)
  : Firsts(input.Surface().triangles.size(), -1)
{
  const TriangleComplex& surface = input.Surface();
  const Lists star = TrianglesOfPoints(static_cast<Id>(surface.points.size()), surface.triangles);
  std::vector<int> sheets;
  for (Id p = 0; p < static_cast<Id>(surface.points.size()); ++p)
  {
    sheets.clear();
    for (Id t : Row(star, p))
    {
      const int sheet = input.TriangleSheet(t);
      if (std::find(sheets.begin(), sheets.end(), sheet) == sheets.end())
      {
        sheets.push_back(sheet);
        this->Add(surface.points[static_cast<std::size_t>(p)], input.Tolerance(p), t);
      }
    }
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Triangle& corners = surface.triangles[t];
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id a = corners[k];
      const Id b = corners[(k + 1) % 3];
      for (const double w : { 0.25, 0.5, 0.75 })
      {
        if (a < b) // inside a sheet one of the two triangles has it so
        {
          this->Add((1 - w) * surface.points[static_cast<std::size_t>(a)] +
                      w * surface.points[static_cast<std::size_t>(b)],
                    (1 - w) * input.Tolerance(a) + w * input.Tolerance(b), static_cast<Id>(t));
        }
      }
    }
  }
}

void InputSamples::Renumber(const std::vector<Id>& order)
{
  std::vector<Sample> places;
  std::vector<int> nexts;
  std::vector<int> firsts;
  places.reserve(this->Places.size());
  nexts.reserve(this->Places.size());
  firsts.reserve(order.size());
  for (Id triangle : order)
  {
    const int first = this->First(triangle);
    firsts.push_back(first < 0 ? -1 : static_cast<int>(places.size()));
    for (int sample = first; sample >= 0; sample = this->Next(sample))
    {
      places.push_back(this->Places[static_cast<std::size_t>(sample)]);
      nexts.push_back(this->Next(sample) < 0 ? -1 : static_cast<int>(places.size()));
    }
  }
  this->Places = std::move(places);
  this->Nexts = std::move(nexts);
  this->Firsts = std::move(firsts);
}

void InputSamples::Add(const Vec3& point, double tolerance, Id triangle)
{
  this->Places.push_back({ point, tolerance });
  this->Nexts.push_back(-1);
  this->Put(static_cast<int>(this->Places.size()) - 1, triangle);
}

} // namespace lamina
