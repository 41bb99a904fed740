// SPDX-License-Identifier: BSD-3-Clause
// The places of one surface that belong to those of another.
#pragma once

#include "Mesh/TriangleComplex.h"
#include "Search/TriangleTree.h"

#include <map>
#include <memory>

namespace lamina::measures
{

inline const Vec3& At(const TriangleComplex& s, Id p)
{
  return s.points[static_cast<std::size_t>(p)];
}

inline std::array<Vec3, 3> CornersAt(const TriangleComplex& s, Id t)
{
  const Triangle& c = s.triangles[static_cast<std::size_t>(t)];
  return { { At(s, c[0]), At(s, c[1]), At(s, c[2]) } };
}

/// Trees of the sheets between the same materials and of the same patch.
class Sheets
{
public:
  using Key = std::array<int, 3>;
  explicit Sheets(const TriangleComplex& s)
    : Surface(s)
  {
    std::map<Key, std::vector<Id>> members;
    for (std::size_t t = 0; t < s.triangles.size(); ++t)
    {
      members[this->KeyOf(t)].push_back(static_cast<Id>(t));
    }
    for (auto& m : members)
    {
      this->Trees[m.first] = std::make_unique<TriangleTree>(s.points, s.triangles, m.second);
    }
  }
  Key KeyOf(std::size_t t) const
  {
    return { { this->Surface.materials[t].first, this->Surface.materials[t].second,
               this->Surface.Patch(static_cast<Id>(t)) } };
  }
  const TriangleTree* Tree(const Key& key) const
  {
    const auto found = this->Trees.find(key);
    return found == this->Trees.end() ? nullptr : found->second.get();
  }

private:
  const TriangleComplex& Surface;
  std::map<Key, std::unique_ptr<TriangleTree>> Trees;
};

} // namespace lamina::measures
