// SPDX-License-Identifier: BSD-3-Clause
#include "FaultScan.h"

namespace lamina
{

namespace
{

/// Call visit(i) for each lattice point of a line whose block is not of one label. The rows are those of the
/// four voxels around the line; null outside the image.
template<typename Visit>
void ForEachMixed(const int* const (&rows)[4], Id length, const Visit& visit)
{
  int before = 0; // the label of the column of voxels below the point, if it has one only
  bool mixedBefore = false;
  for (Id i = 0; i <= length; ++i)
  {
    int here = 0;
    bool mixed = false;
    if (i < length)
    {
      here = rows[0] ? rows[0][i] : 0;
      for (int r = 1; r < 4; ++r)
      {
        mixed = mixed || (rows[r] ? rows[r][i] : 0) != here;
      }
    }
    if (mixed || mixedBefore || here != before)
    {
      visit(i);
    }
    before = here;
    mixedBefore = mixed;
  }
}

struct Layer
{
  Id edges = 0;
  Id corners = 0;
  Id contacts = 0;
};

void ScanLayer(const LabelImage& image, const LabelLattice& lattice, Id k, PointFlags& points, Layer& layer)
{
  const auto& size = image.grid.size;
  for (Id j = 0; j <= size[1]; ++j)
  {
    const int* rows[4];
    for (int r = 0; r < 4; ++r)
    {
      const Id b = j - 1 + (r & 1);
      const Id c = k - 1 + (r >> 1);
      const bool inside = b >= 0 && c >= 0 && b < size[1] && c < size[2];
      rows[r] = inside ? image.labels.data() + image.grid.Index(0, b, c) : nullptr;
    }
    ForEachMixed(rows, size[0],
                 [&](Id i)
                 {
                   const BlockFaults faults = lattice.FaultsAt({ i, j, k });
                   if (faults.All() > 0)
                   {
                     points.Set({ i, j, k }, true);
                     layer.edges += faults.edges;
                     layer.corners += faults.corners;
                     layer.contacts += faults.contacts > 0 ? 1 : 0;
                   }
                 });
  }
}

} // namespace

FaultScan ScanFaults(const LabelImage& image, const LabelLattice& lattice, Monitor& monitor)
{
  const Id count = image.grid.size[2] + 1;
  FaultScan all(lattice);
  std::vector<Layer> layers(static_cast<std::size_t>(count));
  monitor.For(count, 1,
              [&](Id begin, Id end)
              {
                for (Id k = begin; k < end; ++k)
                {
                  ScanLayer(image, lattice, k, all.points, layers[static_cast<std::size_t>(k)]);
                }
              });
  for (const Layer& layer : layers)
  {
    all.counts.criticalEdges += layer.edges;
    all.counts.criticalCorners += layer.corners;
    all.counts.forbiddenContacts += layer.contacts;
  }
  // Both blocks at the ends of a lattice edge tell of it; edges that end outside the lattice are none.
  all.counts.criticalEdges /= 2;
  return all;
}

} // namespace lamina
