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
        this->Points.push_back(p);
        this->Nexts.push_back(-1);
        this->Put(static_cast<int>(this->Points.size()) - 1, t);
      }
    }
  }
}

} // namespace lamina
