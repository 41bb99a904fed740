// SPDX-License-Identifier: BSD-3-Clause
// A made-up image of a heart, with the truth beside it.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/LabelImage.h"
#include "HeartShape.h"

namespace lamina
{

struct HeartPhantomOptions
{
  int resolution = 120;        ///< voxels along the longest axis, 16 to 512
  double length = 120;         ///< world length of the longest axis, > 0
  double blood = 190;          ///< grey value of blood, 0 to 255
  double tissue = 85;          ///< grey value of tissue
  double background = 20;      ///< grey value of everything else
  double noise = 12;           ///< standard deviation in grey levels, >= 0
  double blur = 1;             ///< full width at half maximum of the point spread, in voxels, 0 to 8
  double bias = 0.05;          ///< greatest relative change of brightness over the image, 0 to 1
  unsigned long long seed = 1; ///< of the noise
  bool open = false; ///< great vessels leave through the image's upper border instead of ending inside
};

struct HeartPhantomMaterial
{
  int id = 0;
  Id voxels = 0;
  Id components = 0; ///< over faces, counted
};

/// A rod in the image, in continuous voxel indices.
struct HeartPhantomRod
{
  Vec3 from;
  Vec3 to;
  double fromDiameter = 0; ///< in voxels
  double toDiameter = 0;
};

struct HeartPhantomReport
{
  std::vector<HeartPhantomMaterial> materials; ///< background, tissue, blood
  std::vector<HeartPart> parts;                ///< one a voxel: which part of the heart it is
  std::vector<HeartPhantomRod> coronaries;     ///< as designed, each vessel from its root on
  std::vector<HeartPhantomRod> strands;        ///< as designed: papillary muscles, chordae, tendons
  Id mendedVoxels = 0; ///< made tissue because materials met in an edge or a corner only
};

/// The grid that the image of these options will have.
Result<GridGeometry> HeartPhantomGrid(const HeartPhantomOptions& options);

/// Make the grey image and its true labels (0 background, 1 tissue, 2 blood). The true labels are well
/// separated: blood never touches background, and no material meets itself in an edge or a corner only. The
/// same options give the same image, whatever the number of threads.
Result<HeartPhantomReport> MakeHeartPhantom(GreyImage& grey, LabelImage& labels,
                                            const HeartPhantomOptions& options, Monitor& monitor);

} // namespace lamina
