// SPDX-License-Identifier: BSD-3-Clause
// Walls between blood and background.
#include "SegmentRules.h"

#include <algorithm>

namespace lamina
{
namespace segment
{

namespace
{

/// Which rows hold a label at all: most have no blood near, and need no closer look.
std::vector<unsigned char> RowsWith(const Work& work, int label, Monitor& monitor)
{
  const Id length = work.Size()[0];
  std::vector<unsigned char> rows(work.Size()[1] * work.Size()[2], 0);
  monitor.For(static_cast<Id>(rows.size()), 256,
              [&](Id begin, Id end)
              {
                for (Id r = begin; r < end; ++r)
                {
                  const int* row = work.labels.data() + r * length;
                  rows[r] = std::find(row, row + length, label) != row + length;
                }
              });
  return rows;
}

/// Whether a label stands at or next to each voxel of a row, over faces, edges and corners.
class Surroundings
{
public:
  Surroundings(const Work& work, int label, const std::vector<unsigned char>& rows)
    : Image(work)
    , Label(label)
    , Rows(rows)
    , Across(work.Size()[0])
    , Near(work.Size()[0])
  {
  }
  /// False if there is none in all the row.
  bool Look(Id j, Id k)
  {
    const auto& size = this->Image.Size();
    std::fill(this->Across.begin(), this->Across.end(), static_cast<unsigned char>(0));
    bool any = false;
    for (Id c = std::max<Id>(k - 1, 0); c < std::min(k + 2, size[2]); ++c)
    {
      for (Id b = std::max<Id>(j - 1, 0); b < std::min(j + 2, size[1]); ++b)
      {
        const Id row = b + size[1] * c;
        if (!this->Rows[row])
        {
          continue;
        }
        any = true;
        const int* labels = this->Image.labels.data() + row * size[0];
        for (Id i = 0; i < size[0]; ++i)
        {
          this->Across[i] |= labels[i] == this->Label;
        }
      }
    }
    for (Id i = 0; any && i < size[0]; ++i)
    {
      this->Near[i] =
        this->Across[i] | (i > 0 ? this->Across[i - 1] : 0) | (i + 1 < size[0] ? this->Across[i + 1] : 0);
    }
    return any;
  }
  bool At(Id i) const { return this->Near[i] != 0; }

private:
  const Work& Image;
  int Label;
  const std::vector<unsigned char>& Rows;
  std::vector<unsigned char> Across;
  std::vector<unsigned char> Near;
};

/// The voxels of one slice that become tissue.
struct WallVoxels
{
  std::vector<Id> overBlood;   ///< background that touches blood
  std::vector<Id> imageBorder; ///< blood at the image's border
  std::vector<Id> maskBorder;  ///< blood at the mask's edge
};

class WallFinder
{
public:
  WallFinder(const Work& work, Monitor& monitor)
    : Image(work)
    , BloodRows(RowsWith(work, Blood, monitor))
    , OutsideRows(RowsWith(work, Outside, monitor))
  {
  }
  WallVoxels Find(Id k) const
  {
    WallVoxels found;
    Surroundings blood(this->Image, Blood, this->BloodRows);
    Surroundings outside(this->Image, Outside, this->OutsideRows);
    for (Id j = 0; j < this->Image.Size()[1]; ++j)
    {
      if (blood.Look(j, k))
      {
        const bool atMask = !this->Image.options.openAtMaskBorder && outside.Look(j, k);
        this->FindInRow(j, k, blood, atMask ? &outside : nullptr, found);
      }
    }
    return found;
  }

private:
  /// Outside the mask nothing may change, so there the blood itself gives way.
  void FindInRow(Id j, Id k, const Surroundings& blood, const Surroundings* outside, WallVoxels& found) const
  {
    const auto& size = this->Image.Size();
    const bool closed = !this->Image.options.openAtImageBorder;
    const bool edge = j == 0 || k == 0 || j == size[1] - 1 || k == size[2] - 1;
    const Id first = this->Image.image.grid.Index(0, j, k);
    for (Id i = 0; i < size[0]; ++i)
    {
      const int label = this->Image.labels[first + i];
      if (label == Background && blood.At(i))
      {
        found.overBlood.push_back(first + i);
      }
      else if (label == Blood && closed && (edge || i == 0 || i == size[0] - 1))
      {
        found.imageBorder.push_back(first + i);
      }
      else if (label == Blood && outside && outside->At(i))
      {
        found.maskBorder.push_back(first + i);
      }
    }
  }

  const Work& Image;
  std::vector<unsigned char> BloodRows;
  std::vector<unsigned char> OutsideRows;
};

} // namespace

Id BuildWalls(Work& work, Monitor& monitor)
{
  if (!work.HasWalls())
  {
    return 0;
  }
  const Id slices = work.Size()[2];
  std::vector<WallVoxels> found(slices);
  const WallFinder finder(work, monitor);
  monitor.For(slices, 1,
              [&](Id begin, Id end)
              {
                for (Id k = begin; k < end; ++k)
                {
                  found[k] = finder.Find(k);
                }
              });
  if (monitor.Cancelled())
  {
    return 0;
  }
  Id counts[3] = { 0, 0, 0 };
  for (const WallVoxels& slice : found)
  {
    const std::vector<Id>* lists[3] = { &slice.overBlood, &slice.imageBorder, &slice.maskBorder };
    for (int reason = 0; reason < 3; ++reason)
    {
      for (const Id v : *lists[reason])
      {
        work.labels[v] = Tissue;
      }
      counts[reason] += static_cast<Id>(lists[reason]->size());
    }
  }
  work.Note("background that touches blood", Tissue, 0, counts[0]);
  work.Note("blood at the image's border, closed", Tissue, 0, counts[1]);
  if (work.options.mask)
  {
    work.Note("blood at the mask's edge, closed", Tissue, 0, counts[2]);
  }
  return counts[0] + counts[1] + counts[2];
}

} // namespace segment
} // namespace lamina
