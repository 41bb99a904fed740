// SPDX-License-Identifier: BSD-3-Clause
#include "MaskCut.h"

#include <algorithm>
#include <utility>

namespace lamina
{

namespace
{

using Voxel = std::array<Id, 3>;

class Cutter
{
public:
  Cutter(LabelImage& labels, const LabelImage& mask, const std::vector<int>& materials)
    : Labels(labels)
    , Mask(mask)
    , Materials(materials)
    , Seen(labels.labels.size(), 0)
  {
  }

  std::vector<char> Run()
  {
    const Id count = this->Labels.grid.Count();
    for (Id v = 0; v < count; ++v)
    {
      if (!this->Seen[static_cast<std::size_t>(v)] && this->FacesOutside(this->ToVoxel(v)) != 0)
      {
        this->CutContact(this->GatherContact(v));
      }
    }
    return std::move(this->Taken);
  }

private:
  Voxel ToVoxel(Id v) const
  {
    const auto& s = this->Labels.grid.size;
    return { v % s[0], v / s[0] % s[1], v / s[0] / s[1] };
  }
  bool Inside(const Voxel& v) const
  {
    const auto& s = this->Labels.grid.size;
    return v[0] >= 0 && v[1] >= 0 && v[2] >= 0 && v[0] < s[0] && v[1] < s[1] && v[2] < s[2];
  }
  std::size_t At(const Voxel& v) const
  {
    return static_cast<std::size_t>(this->Labels.grid.Index(v[0], v[1], v[2]));
  }
  bool IsOpenMaterial(const Voxel& v) const
  {
    const int label = this->Labels.labels[this->At(v)];
    return label != 0 &&
           std::find(this->Materials.begin(), this->Materials.end(), label) != this->Materials.end();
  }
  /// Bits 2 * axis + side of the faces of an open-material voxel that look at background outside the mask.
  int FacesOutside(const Voxel& v) const
  {
    if (!this->IsOpenMaterial(v))
    {
      return 0;
    }
    int bits = 0;
    for (int d = 0; d < 6; ++d)
    {
      Voxel n = v;
      n[static_cast<std::size_t>(d / 2)] += d % 2 ? 1 : -1;
      if (this->Inside(n) && this->Labels.labels[this->At(n)] == 0 && this->Mask.labels[this->At(n)] != 1)
      {
        bits |= 1 << d;
      }
    }
    return bits;
  }
  std::vector<Voxel> GatherContact(Id seed);
  void CutContact(const std::vector<Voxel>& contact);

  LabelImage& Labels;
  const LabelImage& Mask;
  const std::vector<int>& Materials;
  std::vector<char> Seen;
  std::vector<char> Taken;
};

/// The 26-connected voxels that look outside, around a seed.
std::vector<Voxel> Cutter::GatherContact(Id seed)
{
  std::vector<Voxel> contact{ this->ToVoxel(seed) };
  this->Seen[static_cast<std::size_t>(seed)] = 1;
  for (std::size_t next = 0; next < contact.size(); ++next)
  {
    for (int q = 0; q < 27; ++q)
    {
      const Voxel n{ contact[next][0] + q % 3 - 1, contact[next][1] + q / 3 % 3 - 1,
                     contact[next][2] + q / 9 - 1 };
      if (this->Inside(n) && !this->Seen[this->At(n)] && this->FacesOutside(n) != 0)
      {
        this->Seen[this->At(n)] = 1;
        contact.push_back(n);
      }
    }
  }
  return contact;
}

void Cutter::CutContact(const std::vector<Voxel>& contact)
{
  std::array<Id, 6> facing{};
  for (const Voxel& v : contact)
  {
    const int bits = this->FacesOutside(v);
    for (std::size_t d = 0; d < 6; ++d)
    {
      facing[d] += bits >> d & 1;
    }
  }
  const std::size_t d =
    static_cast<std::size_t>(std::max_element(facing.begin(), facing.end()) - facing.begin());
  const std::size_t axis = d / 2;
  const bool high = d % 2 == 1;
  Id deepest = contact[0][axis];
  for (const Voxel& v : contact)
  {
    deepest = high ? std::min(deepest, v[axis]) : std::max(deepest, v[axis]);
  }
  // Flood from the contact over the open material up to the plane; the contact itself goes too.
  const int material = this->Labels.labels[this->At(contact[0])];
  const auto total = std::count(this->Labels.labels.begin(), this->Labels.labels.end(), material);
  std::vector<Voxel> beyond;
  std::vector<int> before;
  const auto take = [&](const Voxel& v)
  {
    if (this->Inside(v) && this->IsOpenMaterial(v) && (high ? v[axis] >= deepest : v[axis] <= deepest))
    {
      before.push_back(this->Labels.labels[this->At(v)]);
      this->Labels.labels[this->At(v)] = 0;
      beyond.push_back(v);
    }
  };
  for (const Voxel& v : contact)
  {
    take(v);
  }
  for (std::size_t next = 0; next < beyond.size(); ++next)
  {
    for (int s = 0; s < 6; ++s)
    {
      Voxel n = beyond[next];
      n[static_cast<std::size_t>(s / 2)] += s % 2 ? 1 : -1;
      take(n);
    }
  }
  const bool tooMuch = 5 * static_cast<std::ptrdiff_t>(beyond.size()) > total;
  this->Taken.resize(this->Labels.labels.size(), 0);
  for (std::size_t n = 0; n < beyond.size(); ++n)
  {
    if (tooMuch)
    {
      this->Labels.labels[this->At(beyond[n])] = before[n];
    }
    else
    {
      this->Taken[this->At(beyond[n])] = 1;
    }
  }
}

} // namespace

std::vector<char> CutMaterialsAtMask(LabelImage& labels, const LabelImage& mask,
                                     const std::vector<int>& materials)
{
  return Cutter(labels, mask, materials).Run();
}

} // namespace lamina
