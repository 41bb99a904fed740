// SPDX-License-Identifier: BSD-3-Clause
// The audit's part on truth: volumes against the image's voxels, and interfaces against the border between
// them.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/LabelImage.h"
#include "../Mesh/MeshPatches.h"

namespace lamina
{

/// A connected piece of a material, in the mesh and in the image.
struct PieceVolume
{
  int material = 0;
  Id voxels = 0;
  double voxelVolume = 0;
  double meshVolume = 0;
};

/// How far the interface of two materials lies from the faces between their voxels, in voxels (the cube root
/// of a voxel's volume): at the middles of its triangles, weighted by area.
struct InterfaceDistance
{
  MaterialPair pair;
  double median = 0;
  double p95 = 0;
  double largest = 0;
  double within = 1; ///< share of the area within half a voxel
};

struct ImageAudit
{
  std::vector<PieceVolume> materials;
  std::vector<PieceVolume> pieces; ///< of the image, of 1,000 voxels or more, the largest of a material first
  std::vector<InterfaceDistance> interfaces;
  double largestMaterialError = 0; ///< relative
  double largestPieceError = 0;
};

/// Compare a mesh with the labels it was made from. `scale` is the factor on the image's lengths.
Result<ImageAudit> AuditAgainstImage(const VolumeMesh& mesh, const MeshPatches& patches,
                                     const LabelImage& image, double scale, Monitor& monitor);

} // namespace lamina
