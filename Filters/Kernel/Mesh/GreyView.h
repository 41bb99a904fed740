// SPDX-License-Identifier: BSD-3-Clause
// Grey values read where they lie, whatever their number type: an image in memory once is enough.
#pragma once

#include "LabelImage.h"

#include <memory>

namespace lamina
{

/// One grey value a voxel, of any number type, owned by somebody else unless `keep` holds them. Cheap to
/// copy.
class GreyView
{
public:
  GreyView() = default;
  /// `count` values of type T, i fastest; `keep` is held as long as the view lives.
  template<typename T>
  GreyView(const GridGeometry& geometry, const T* values, Id count,
           std::shared_ptr<const void> keep = nullptr)
    : grid(geometry)
    , Values(values)
    , Size(count)
    , Copy(&CopyAs<T>)
    , Keep(std::move(keep))
  {
  }
  /// Of an image that outlives the view.
  GreyView(const GreyImage& image)
    : GreyView(image.grid, image.values.data(), static_cast<Id>(image.values.size()))
  {
  }

  Id Count() const { return this->Size; }
  /// Write the values of the voxels [begin, end) to `values`.
  void Read(Id begin, Id end, double* values) const { this->Copy(this->Values, begin, end, values); }
  double At(Id voxel) const
  {
    double value = 0;
    this->Read(voxel, voxel + 1, &value);
    return value;
  }

  GridGeometry grid;

private:
  using CopyValues = void (*)(const void* from, Id begin, Id end, double* to);

  template<typename T>
  static void CopyAs(const void* from, Id begin, Id end, double* to)
  {
    const T* values = static_cast<const T*>(from);
    for (Id v = begin; v < end; ++v)
    {
      *to++ = static_cast<double>(values[v]);
    }
  }

  const void* Values = nullptr;
  Id Size = 0;
  CopyValues Copy = nullptr;
  std::shared_ptr<const void> Keep;
};

} // namespace lamina
