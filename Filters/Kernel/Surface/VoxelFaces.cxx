// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelFaces.h"

#include <algorithm>

namespace lamina
{

namespace
{

class FaceCollector
{
public:
  FaceCollector(const LabelImage& image, const ExtractInterfacesOptions& options,
                const std::vector<char>& cut)
    : Image(image)
    , Options(options)
    , Cut(cut)
    , Size(image.grid.size)
  {
  }
  void CollectSlice(Id k, std::vector<VoxelFace>& faces) const;

private:
  int Label(const std::array<Id, 3>& v, bool& outside) const
  {
    outside = v[0] < 0 || v[1] < 0 || v[2] < 0 || v[0] >= this->Size[0] || v[1] >= this->Size[1] ||
              v[2] >= this->Size[2];
    return outside ? 0
                   : this->Image.labels[static_cast<std::size_t>(this->Image.grid.Index(v[0], v[1], v[2]))];
  }
  /// Whether voxel (i, j, k) and those before it along each axis are inside and of one label, as most are.
  bool IsUniform(Id i, Id j, Id k) const
  {
    if (i < 1 || j < 1 || k < 1 || i >= this->Size[0] || j >= this->Size[1] || k >= this->Size[2])
    {
      return false;
    }
    const int* label = this->Image.labels.data() + this->Image.grid.Index(i, j, k);
    const Id row = this->Size[0];
    return label[0] == label[-1] && label[0] == label[-row] && label[0] == label[-row * this->Size[1]];
  }
  bool WasCut(const std::array<Id, 3>& v) const
  {
    return !this->Cut.empty() &&
           this->Cut[static_cast<std::size_t>(this->Image.grid.Index(v[0], v[1], v[2]))];
  }
  bool IsOpen(const VoxelFace& face, const std::array<Id, 3>& low, const std::array<Id, 3>& high) const;

  const LabelImage& Image;
  const ExtractInterfacesOptions& Options;
  const std::vector<char>& Cut; ///< voxels that a plane end at the mask's edge took
  std::array<Id, 3> Size;
};

bool FaceCollector::IsOpen(const VoxelFace& face, const std::array<Id, 3>& low,
                           const std::array<Id, 3>& high) const
{
  const int material = face.low == 0 ? face.high : face.low;
  const auto& open = this->Options.openMaterials;
  if ((face.low != 0 && face.high != 0) || std::find(open.begin(), open.end(), material) == open.end())
  {
    return false;
  }
  if (face.plane != 0)
  {
    return this->Options.openAtImageBorder;
  }
  return this->WasCut(face.low == 0 ? low : high);
}

void FaceCollector::CollectSlice(Id k, std::vector<VoxelFace>& faces) const
{
  for (Id j = 0; j <= this->Size[1]; ++j)
  {
    for (Id i = 0; i <= this->Size[0]; ++i)
    {
      if (this->IsUniform(i, j, k))
      {
        continue;
      }
      const std::array<Id, 3> high{ i, j, k };
      bool outsideHigh = false;
      const int labelHigh = this->Label(high, outsideHigh);
      for (int axis = 0; axis < 3; ++axis)
      {
        std::array<Id, 3> low = high;
        --low[static_cast<std::size_t>(axis)];
        bool outsideLow = false;
        const int labelLow = this->Label(low, outsideLow);
        if (labelLow == labelHigh)
        {
          continue;
        }
        VoxelFace face{ high, axis, labelLow, labelHigh, 0, false };
        face.plane = outsideLow ? 1 + 2 * axis : (outsideHigh ? 2 + 2 * axis : 0);
        face.open = this->IsOpen(face, low, high);
        faces.push_back(face);
      }
    }
  }
}

} // namespace

std::array<std::array<Id, 3>, 4> VoxelFace::Corners() const
{
  const auto u = static_cast<std::size_t>((this->axis + 1) % 3);
  const auto v = static_cast<std::size_t>((this->axis + 2) % 3);
  std::array<std::array<Id, 3>, 4> corners{ { this->corner, this->corner, this->corner, this->corner } };
  ++corners[1][u];
  ++corners[2][u];
  ++corners[2][v];
  ++corners[3][v];
  return corners;
}

std::optional<std::vector<VoxelFace>> CollectVoxelFaces(const LabelImage& image,
                                                        const ExtractInterfacesOptions& options,
                                                        const std::vector<char>& cut, Monitor& monitor)
{
  const FaceCollector collector(image, options, cut);
  std::vector<std::vector<VoxelFace>> slices(static_cast<std::size_t>(image.grid.size[2] + 1));
  monitor.For(image.grid.size[2] + 1, 2,
              [&](Id begin, Id end)
              {
                for (Id k = begin; k < end; ++k)
                {
                  collector.CollectSlice(k, slices[static_cast<std::size_t>(k)]);
                }
              });
  if (monitor.Cancelled())
  {
    return std::nullopt;
  }
  std::vector<VoxelFace> faces;
  for (const auto& slice : slices)
  {
    faces.insert(faces.end(), slice.begin(), slice.end());
  }
  return faces;
}

} // namespace lamina
