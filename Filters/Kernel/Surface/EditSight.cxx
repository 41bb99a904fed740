// SPDX-License-Identifier: BSD-3-Clause
// How well the nodes of an edited surface see their faces.
#include "../Geometry/VisibleDirection.h"
#include "EditCorners.h"
#include "EditableSurface.h"

#include <algorithm>
#include <cmath>

namespace lamina
{

namespace
{

constexpr double rounding = 1e-12;
constexpr double sharpness = 20; ///< how much more the worst faces count where a node is uncovered
constexpr double leastVisibilityMending = 0.42; ///< the same while a node is uncovered that sees less
constexpr double leastVisibility = 0.45; ///< cosine between a node's best direction and the faces it must see

} // namespace

/// The least, over the materials at p, of how well the best direction into the material sees its faces there.
/// With an edit: as it would be after it.
/// `blocked`: if not null, becomes the sum over all faces of how much each hinders the sight, which falls
/// where any of the worst faces gets better, even if others are still as bad.
double EditableSurface::Visibility(Id p, const Edit* edit, double* blocked) const
{
  struct Face
  {
    Vec3 normal;
    MaterialPair pair;
  };
  ShortList<Face, 32> faces;
  const auto add = [&](const Vec3& normal, int sheet)
  {
    faces.push_back(
      { normal, this->Input.Surface()
                  .materials[static_cast<std::size_t>(this->PairOfSheet[static_cast<std::size_t>(sheet)])] });
  };
  for (Id t : this->Star(p))
  {
    if (edit == nullptr || !std::binary_search(edit->removed.begin(), edit->removed.end(), t))
    {
      add(this->Normals[static_cast<std::size_t>(t)], this->Sheets[static_cast<std::size_t>(t)]);
    }
  }
  if (edit != nullptr)
  {
    for (const Added& t : edit->added)
    {
      if (t.corners[0] == p || t.corners[1] == p || t.corners[2] == p)
      {
        add(t.normal, t.sheet);
      }
    }
  }
  // A point of a sheet has one pair: its cone is the same seen from both sides.
  double least = 1;
  double sumOfAll = 0;
  ShortList<int, 8> done;
  std::vector<Vec3> normals;
  normals.reserve(faces.size());
  for (const Face& face : faces)
  {
    for (int material : { face.pair.first, face.pair.second })
    {
      if (std::find(done.begin(), done.end(), material) != done.end() || material == 0)
      {
        continue;
      }
      done.push_back(material);
      normals.clear();
      Vec3 sum;
      for (const Face& other : faces)
      {
        const int side = SideOf(other.pair, material);
        if (side != 0)
        {
          normals.push_back(side * other.normal);
          sum += normals.back();
        }
      }
      const Vec3 mean = Normalized(sum);
      double seen = 1;
      for (const Vec3& n : normals)
      {
        seen = std::min(seen, Dot(mean, n));
      }
      VisibleDirection best{ mean, seen };
      if (seen < leastVisibility || blocked != nullptr)
      {
        best = FindVisibleDirection(normals);
      }
      least = std::min(least, best.leastCosine);
      for (std::size_t i = 0; blocked != nullptr && i < normals.size(); ++i)
      {
        sumOfAll += std::exp(-sharpness * Dot(best.direction, normals[i]));
      }
    }
    if (this->Classes[static_cast<std::size_t>(p)] == OnSheet)
    {
      break;
    }
  }
  if (blocked != nullptr)
  {
    *blocked = sumOfAll;
  }
  return least;
}

/// Visibility after an edit, or a lower bound of it that is good enough.
double EditableSurface::SightAfter(Id p, const Edit& edit) const
{
  if (this->Classes[static_cast<std::size_t>(p)] == OnSheet)
  {
    // Most often the mean normal sees all faces well: no need to look for the best.
    ShortList<Vec3, 24> normals;
    Vec3 sum;
    const auto add = [&](const Vec3& normal)
    {
      normals.push_back(normal);
      sum += normal;
    };
    for (Id t : this->Star(p))
    {
      if (!std::binary_search(edit.removed.begin(), edit.removed.end(), t))
      {
        add(this->Normals[static_cast<std::size_t>(t)]);
      }
    }
    for (const Added& t : edit.added)
    {
      if (Has(t.corners, p))
      {
        add(t.normal);
      }
    }
    double least = 1;
    const Vec3 mean = Normalized(sum);
    for (const Vec3& normal : normals)
    {
      least = std::min(least, Dot(mean, normal));
    }
    if (least >= 0.6)
    {
      return least;
    }
  }
  return this->Visibility(p, &edit);
}

bool EditableSurface::KeepsNodesVisible(const Edit& edit, bool& allVisible) const
{
  ShortList<Id, 32> nodes;
  for (const Added& t : edit.added)
  {
    for (Id p : t.corners)
    {
      if (std::find(nodes.begin(), nodes.end(), p) == nodes.end())
      {
        nodes.push_back(p);
      }
    }
  }
  if (const auto mended = std::find(nodes.begin(), nodes.end(), this->Mended); mended != nodes.end())
  {
    std::swap(*mended, *nodes.begin()); // what is most often in the way comes first
  }
  for (Id p : nodes)
  {
    // A node that was hidden before may stay so, but no edit may hide it more.
    const double after = this->SightAfter(p, edit);
    allVisible = allVisible && after >= leastVisibility;
    if (p == this->Mended && after < goodSight)
    {
      double blocked = 0;
      this->Visibility(p, &edit, &blocked);
      if (blocked > this->MostBlocked)
      {
        return false;
      }
    }
    const double least = this->Mending ? leastVisibilityMending : leastVisibility;
    if (after < least && after < this->Visibility(p) - rounding)
    {
      return false;
    }
  }
  return true;
}

} // namespace lamina
