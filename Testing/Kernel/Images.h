// SPDX-License-Identifier: BSD-3-Clause
// Label images of simple shapes, and what is known about them.
#pragma once

#include "Mesh/LabelImage.h"

#include <cmath>
#include <random>

namespace lamina::images
{

/// An image whose voxel (i, j, k) holds label(i, j, k).
template<typename Label>
LabelImage Make(const std::array<Id, 3>& size, Label&& label)
{
  LabelImage image;
  image.grid.size = size;
  for (Id k = 0; k < size[2]; ++k)
  {
    for (Id j = 0; j < size[1]; ++j)
    {
      for (Id i = 0; i < size[0]; ++i)
      {
        image.labels.push_back(label(i, j, k));
      }
    }
  }
  return image;
}

/// A cube of n voxels a side; label(x, y, z) gets the position from its centre, in voxels.
template<typename Label>
LabelImage MakeCentred(Id n, Label&& label)
{
  const double c = 0.5 * static_cast<double>(n - 1);
  return Make(
    { { n, n, n } }, [&](Id i, Id j, Id k)
    { return label(static_cast<double>(i) - c, static_cast<double>(j) - c, static_cast<double>(k) - c); });
}

inline LabelImage Ball(Id n, double radius)
{
  return MakeCentred(n, [=](double x, double y, double z)
                     { return x * x + y * y + z * z < radius * radius ? 1 : 0; });
}

/// Material 1 between two spheres, material 2 inside.
inline LabelImage Shell(Id n, double inner, double outer)
{
  return MakeCentred(n,
                     [=](double x, double y, double z)
                     {
                       const double r = std::sqrt(x * x + y * y + z * z);
                       return r < inner ? 2 : (r < outer ? 1 : 0);
                     });
}

/// A cylinder along z through the whole image (or, with `capped`, ending inside it), cut into materials 1, 2
/// and 3 by three half-planes through its axis.
inline LabelImage Sectors(Id n, double radius, bool capped)
{
  const double half = 0.5 * static_cast<double>(n) - 2;
  return MakeCentred(n,
                     [=](double x, double y, double z)
                     {
                       if (x * x + y * y > radius * radius || (capped && std::abs(z) > half))
                       {
                         return 0;
                       }
                       const double turn = std::atan2(y + 0.1, x + 0.1) / 2.0943951023931953;
                       return turn < -0.5 ? 1 : (turn < 0.5 ? 2 : 3);
                     });
}

/// Every voxel one of `labels` labels, background among them.
inline LabelImage Noise(Id n, int labels, unsigned seed)
{
  std::mt19937 random(seed);
  return Make({ { n, n, n } },
              [&](Id, Id, Id) { return static_cast<int>(random() % static_cast<unsigned>(labels)); });
}

/// The voxels of a material, in the volume of one.
inline double CountOf(const LabelImage& image, int material)
{
  double count = 0;
  for (int label : image.labels)
  {
    count += label == material ? 1 : 0;
  }
  return count;
}

} // namespace lamina::images
