// SPDX-License-Identifier: BSD-3-Clause
#include "BettiNumbers.h"

#include "ConnectedComponents.h"

#include <algorithm>
#include <map>

namespace lamina
{

namespace
{

using Index = std::array<Id, 3>;

/// The box of voxels that hold a material; high is one past the last.
struct Box
{
  Index low{ { 0, 0, 0 } };
  Index high{ { 0, 0, 0 } };
  bool empty = true;

  void Add(const Index& from, const Index& to)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->low[axis] = this->empty ? from[axis] : std::min(this->low[axis], from[axis]);
      this->high[axis] = this->empty ? to[axis] : std::max(this->high[axis], to[axis]);
    }
    this->empty = false;
  }
};

std::map<int, Box> FindBoxes(const LabelImage& image, Monitor& monitor)
{
  const Index& size = image.grid.size;
  std::vector<std::map<int, Box>> slices(static_cast<std::size_t>(size[2]));
  monitor.For(size[2], 1,
              [&](Id begin, Id end)
              {
                for (Id k = begin; k < end; ++k)
                {
                  auto& boxes = slices[static_cast<std::size_t>(k)];
                  for (Id j = 0; j < size[1]; ++j)
                  {
                    const int* row = image.labels.data() + image.grid.Index(0, j, k);
                    for (Id from = 0; from < size[0];)
                    {
                      Id to = from + 1;
                      while (to < size[0] && row[to] == row[from])
                      {
                        ++to;
                      }
                      boxes[row[from]].Add({ from, j, k }, { to, j + 1, k + 1 });
                      from = to;
                    }
                  }
                }
              });
  std::map<int, Box> all;
  all[0].Add({ 0, 0, 0 }, size); // background lies around the whole image
  for (const auto& boxes : slices)
  {
    for (const auto& item : boxes)
    {
      all[item.first].Add(item.second.low, item.second.high);
    }
  }
  return all;
}

/// One material (1) and the rest (0) in its box, one voxel wider on all sides.
struct Cutout
{
  Index size{ { 0, 0, 0 } };
  std::vector<int> inside;
};

Cutout CutOut(const LabelImage& image, int material, const Box& box, Monitor& monitor)
{
  Cutout out;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    out.size[axis] = box.high[axis] - box.low[axis] + 2;
  }
  out.inside.assign(static_cast<std::size_t>(out.size[0] * out.size[1] * out.size[2]), material == 0 ? 1 : 0);
  monitor.For(out.size[2] - 2, 4,
              [&](Id begin, Id end)
              {
                for (Id k = begin; k < end; ++k)
                {
                  for (Id j = 0; j + 2 < out.size[1]; ++j)
                  {
                    const int* from =
                      image.labels.data() + image.grid.Index(box.low[0], box.low[1] + j, box.low[2] + k);
                    int* to = out.inside.data() + 1 + out.size[0] * (j + 1 + out.size[1] * (k + 1));
                    for (Id i = 0; i + 2 < out.size[0]; ++i)
                    {
                      to[i] = from[i] == material ? 1 : 0;
                    }
                  }
                }
              });
  return out;
}

struct CellCounts
{
  Id voxels = 0;
  Id euler = 0;
};

/// The voxels of a slice and its share of the Euler number: its voxels, and the pairs, squares and blocks
/// that begin in it.
CellCounts CountSlice(const Cutout& cut, Id k)
{
  CellCounts counts;
  const bool above = k + 1 < cut.size[2];
  for (Id j = 0; j < cut.size[1]; ++j)
  {
    const bool behind = j + 1 < cut.size[1];
    const int* row = cut.inside.data() + cut.size[0] * (j + cut.size[1] * k);
    const int* y = behind ? row + cut.size[0] : nullptr;
    const int* z = above ? row + cut.size[0] * cut.size[1] : nullptr;
    const int* yz = above && behind ? z + cut.size[0] : nullptr;
    int before[4] = { 0, 0, 0, 0 }; // at i - 1: the voxel, the pair along j, the pair along k, the square
    for (Id i = 0; i < cut.size[0]; ++i)
    {
      const int v = row[i];
      const int pairY = y ? v & y[i] : 0;
      const int pairZ = z ? v & z[i] : 0;
      const int square = yz ? pairY & z[i] & yz[i] : 0;
      counts.voxels += v;
      counts.euler += v - (before[0] & v) - pairY - pairZ + (before[1] & pairY) + (before[2] & pairZ) +
                      square - (before[3] & square);
      before[0] = v;
      before[1] = pairY;
      before[2] = pairZ;
      before[3] = square;
    }
  }
  return counts;
}

CellCounts CountCells(const Cutout& cut, Monitor& monitor)
{
  std::vector<CellCounts> slices(static_cast<std::size_t>(cut.size[2]));
  monitor.For(cut.size[2], 4,
              [&](Id begin, Id end)
              {
                for (Id k = begin; k < end; ++k)
                {
                  slices[static_cast<std::size_t>(k)] = CountSlice(cut, k);
                }
              });
  CellCounts all;
  for (const CellCounts& slice : slices)
  {
    all.voxels += slice.voxels;
    all.euler += slice.euler;
  }
  return all;
}

} // namespace

std::vector<BettiNumbers> CountBettiNumbers(const LabelImage& image, Monitor& monitor)
{
  std::vector<BettiNumbers> all;
  const std::map<int, Box> boxes = FindBoxes(image, monitor);
  Id voxelsInImage = 0;
  for (const auto& item : boxes)
  {
    monitor.Progress(static_cast<double>(all.size()) / static_cast<double>(boxes.size()),
                     "counting Betti numbers");
    if (monitor.Cancelled())
    {
      return {};
    }
    const int material = item.first;
    const Cutout cut = CutOut(image, material, item.second, monitor);
    const CellCounts cells = CountCells(cut, monitor);
    BettiNumbers numbers;
    numbers.material = material;
    numbers.voxels = cells.voxels;
    const ComponentMap pieces = FindComponents(cut.inside, cut.size, Connectivity::Faces, monitor);
    const ComponentMap rest = FindComponents(cut.inside, cut.size, Connectivity::Corners, monitor);
    numbers.b0 = pieces.CountOf(1);
    // What lies around a material is no cavity in it; around background there is nothing but itself.
    numbers.b2 = rest.CountOf(0) - (material == 0 ? 0 : 1);
    numbers.b1 = numbers.b0 + numbers.b2 - cells.euler;
    all.push_back(numbers);
    voxelsInImage += material == 0 ? 0 : numbers.voxels;
  }
  all.front().voxels = image.grid.Count() - voxelsInImage; // without the surrounding
  return all;
}

} // namespace lamina
