// SPDX-License-Identifier: BSD-3-Clause
#include "MaterialContacts.h"

#include <algorithm>

namespace lamina
{

namespace
{

/// The pairs in one layer of lattice points and the voxels of one slice, as a thread finds them.
struct LayerFindings
{
  std::vector<std::array<int, 2>> pairs; ///< the smaller id first, ascending, each once
  std::vector<std::array<Id, 2>> voxels; ///< (material, count), ascending, one entry a material
};

/// Rows of a slice, with background where there is none.
class Rows
{
public:
  explicit Rows(const LabelImage& image)
    : Image(image)
    , Empty(static_cast<std::size_t>(image.grid.size[0]), 0)
  {
  }
  const int* At(Id j, Id k) const
  {
    const auto& size = this->Image.grid.size;
    const bool inside = j >= 0 && k >= 0 && j < size[1] && k < size[2];
    return inside ? this->Image.labels.data() + this->Image.grid.Index(0, j, k) : this->Empty.data();
  }

private:
  const LabelImage& Image;
  std::vector<int> Empty;
};

using Column = std::array<int, 4>; ///< the labels at one i of the four rows around a line of lattice points

void AddPairs(const Column& a, const Column& b, LayerFindings& out)
{
  int labels[8] = { a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3] };
  std::sort(labels, labels + 8);
  const auto end = std::unique(labels, labels + 8);
  for (int* p = labels; p != end; ++p)
  {
    for (int* q = p + 1; q < end; ++q)
    {
      if (out.pairs.empty() || out.pairs.back() != std::array<int, 2>{ *p, *q })
      {
        out.pairs.push_back({ *p, *q });
      }
    }
  }
}

void LookAtLine(const Rows& rows, Id j, Id k, Id length, LayerFindings& out)
{
  const int* row[4] = { rows.At(j - 1, k - 1), rows.At(j, k - 1), rows.At(j - 1, k), rows.At(j, k) };
  Column before{ { 0, 0, 0, 0 } };
  for (Id i = 0; i <= length; ++i)
  {
    const Column here =
      i < length ? Column{ { row[0][i], row[1][i], row[2][i], row[3][i] } } : Column{ { 0, 0, 0, 0 } };
    const bool uniform = here == before && here[0] == here[1] && here[1] == here[2] && here[2] == here[3];
    if (!uniform)
    {
      AddPairs(before, here, out);
    }
    before = here;
  }
}

void SortUnique(std::vector<std::array<int, 2>>& pairs)
{
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

/// One entry a material.
void SumCounts(std::vector<std::array<Id, 2>>& voxels)
{
  std::sort(voxels.begin(), voxels.end());
  std::size_t kept = 0;
  for (std::size_t n = 0; n < voxels.size(); ++n)
  {
    if (kept > 0 && voxels[kept - 1][0] == voxels[n][0])
    {
      voxels[kept - 1][1] += voxels[n][1];
    }
    else
    {
      voxels[kept++] = voxels[n];
    }
  }
  voxels.resize(kept);
}

void CountSlice(const LabelImage& image, Id k, LayerFindings& out)
{
  const Id area = image.grid.size[0] * image.grid.size[1];
  const int* slice = image.labels.data() + k * area;
  std::size_t compressed = 0;
  for (Id begin = 0; begin < area;)
  {
    Id end = begin + 1;
    while (end < area && slice[end] == slice[begin])
    {
      ++end;
    }
    out.voxels.push_back({ slice[begin], end - begin });
    begin = end;
    if (out.voxels.size() >= compressed + 4096)
    {
      SumCounts(out.voxels);
      compressed = out.voxels.size();
    }
  }
  SumCounts(out.voxels);
  out.voxels.shrink_to_fit();
}

} // namespace

void MaterialContacts::Add(int a, int b)
{
  this->Pairs.insert(Key(a, b));
  if (a >= 0 && b >= 0 && a < 64 && b < 64)
  {
    this->Low[static_cast<std::size_t>(a)] |= 1ull << b;
    this->Low[static_cast<std::size_t>(b)] |= 1ull << a;
  }
}

MaterialContacts::MaterialContacts(const LabelImage& image, Monitor& monitor)
{
  const auto& size = image.grid.size;
  const Rows rows(image);
  std::vector<LayerFindings> layers(static_cast<std::size_t>(size[2] + 1));
  monitor.For(size[2] + 1, 1,
              [&](Id begin, Id end)
              {
                for (Id k = begin; k < end; ++k)
                {
                  LayerFindings& layer = layers[static_cast<std::size_t>(k)];
                  for (Id j = 0; j <= size[1]; ++j)
                  {
                    LookAtLine(rows, j, k, size[0], layer);
                    if (layer.pairs.size() > 4096)
                    {
                      SortUnique(layer.pairs);
                    }
                  }
                  SortUnique(layer.pairs);
                  if (k < size[2])
                  {
                    CountSlice(image, k, layer);
                  }
                }
              });
  for (const LayerFindings& layer : layers)
  {
    for (const auto& pair : layer.pairs)
    {
      this->Add(pair[0], pair[1]);
    }
    for (const auto& run : layer.voxels)
    {
      const std::size_t material = static_cast<std::size_t>(run[0]);
      this->Counts.resize(std::max(this->Counts.size(), material + 1), 0);
      this->Counts[material] += run[1];
    }
  }
}

} // namespace lamina
