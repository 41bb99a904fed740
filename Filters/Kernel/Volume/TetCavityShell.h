// SPDX-License-Identifier: BSD-3-Clause
// The outside of some tetrahedra of a cavity.
#pragma once

#include "../Mesh/TetFaces.h"
#include "TetCavity.h"

#include <algorithm>
#include <limits>

namespace lamina
{

struct TetCavity::Shell
{
  std::vector<Id> tets;
  std::vector<Triangle> faces;
  std::vector<Id> inside;      ///< one a face: its tet
  std::vector<double> quality; ///< one a face: of a tet on it, not a number until someone asks

  void Add(Id tet, const Tet& corners)
  {
    this->tets.push_back(tet);
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Triangle face = TetFace(corners, k);
      const auto same = [&](const Triangle& other)
      { return std::is_permutation(face.begin(), face.end(), other.begin()); };
      const auto found = std::find_if(this->faces.begin(), this->faces.end(), same);
      if (found == this->faces.end())
      {
        this->faces.push_back(face);
        this->inside.push_back(tet);
        this->quality.push_back(std::numeric_limits<double>::quiet_NaN());
      }
      else
      {
        this->inside.erase(this->inside.begin() + (found - this->faces.begin()));
        this->quality.erase(this->quality.begin() + (found - this->faces.begin()));
        this->faces.erase(found);
      }
    }
  }
};

} // namespace lamina
