// SPDX-License-Identifier: BSD-3-Clause
// The voxels of a label image as a mesh made from it sees them.
#pragma once

#include "../Mesh/LabelImage.h"
#include "../Mesh/TriangleComplex.h"
#include "AuditImage.h"

namespace lamina
{

/// The image in the mesh's lengths.
class ImageVoxels
{
public:
  ImageVoxels(const LabelImage& image, double scale)
    : Image(image)
    , Scale(scale)
  {
  }
  /// Position in voxels: whole numbers are the middles.
  Vec3 Locate(const Vec3& world) const
  {
    const Vec3 p = world * (1 / this->Scale) - this->Image.grid.origin;
    const auto& d = this->Image.grid.direction;
    const Vec3& s = this->Image.grid.spacing;
    return { (d[0] * p.x + d[3] * p.y + d[6] * p.z) / s.x, (d[1] * p.x + d[4] * p.y + d[7] * p.z) / s.y,
             (d[2] * p.x + d[5] * p.y + d[8] * p.z) / s.z };
  }
  bool Has(const std::array<Id, 3>& v) const
  {
    const auto& n = this->Image.grid.size;
    return v[0] >= 0 && v[1] >= 0 && v[2] >= 0 && v[0] < n[0] && v[1] < n[1] && v[2] < n[2];
  }
  /// Background outside the image.
  int Label(const std::array<Id, 3>& v) const
  {
    return this->Has(v)
             ? this->Image.labels[static_cast<std::size_t>(this->Image.grid.Index(v[0], v[1], v[2]))]
             : 0;
  }
  double Volume() const { return this->Image.grid.VoxelVolume() * this->Scale * this->Scale * this->Scale; }
  double Edge() const { return std::cbrt(this->Image.grid.VoxelVolume()); }

  /// Distance to the nearest face between voxels of the two materials, in the image's lengths; no more than
  /// some voxels are searched.
  double ToBorder(const Vec3& world, const MaterialPair& pair) const;
  const LabelImage& Labels() const { return this->Image; }

private:
  double NearestFace(const Vec3& at, const std::array<Id, 3>& home, int reach,
                     const MaterialPair& pair) const;
  /// The square of the distance to the square between a voxel and the next one along the axis.
  double ToFace2(const Vec3& at, const std::array<Id, 3>& voxel, std::size_t axis) const;

  const LabelImage& Image;
  double Scale;
};

/// Volumes of materials and pieces against the voxels', into the audit.
void CompareVolumes(const VolumeMesh& mesh, const ImageVoxels& voxels, ImageAudit& audit);

} // namespace lamina
