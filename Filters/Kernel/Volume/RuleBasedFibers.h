// SPDX-License-Identifier: BSD-3-Clause
// Directions of muscle fibres by rule: from the depth in the wall and two angles.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/MeshPatches.h"
#include "../Mesh/VolumeMesh.h"

namespace lamina
{

struct FiberOptions
{
  std::vector<int> materials{ 1 };      ///< that have fibres
  std::vector<std::string> endocardium; ///< names of patches; empty: all interfaces of the materials
  std::vector<std::string> epicardium;  ///< names of patches; empty: all their walls
  double helixEndo = 60;                ///< degrees from the circumference, at the endocardium
  double helixEpi = -60;                ///< and at the epicardium, -90 to 90
  double transverse = 0;                ///< degrees towards the epicardium, -90 to 90
  Vec3 axis; ///< along which the heart is long; zero: the longest of the materials' cells
};

struct FiberReport
{
  Id cells = 0; ///< with a fibre
  Vec3 axis;    ///< that was used, of length 1
  Id undecided =
    0; ///< cells where the wall runs across the axis, which got the direction of their neighbourhood's rule
};

/// One a cell; zero and -1 where there is no fibre.
struct FiberField
{
  std::vector<Vec3> fibers;
  std::vector<Vec3> sheets;  ///< across the wall, from endo- to epicardium, orthogonal to the fibre
  std::vector<double> depth; ///< 0 endocardium, 1 epicardium
};

/// With the distances a and b of a cell's middle from endo- and epicardium, the depth is a / (a + b); across
/// the wall is the direction between the closest points of both; around it is axis x across; the fibre turns
/// from there towards the axis by an angle that is linear in the depth. Sources: Streeter, Spotnitz, Patel,
/// Ross, Sonnenblick: Fiber orientation in the canine left ventricle during diastole and systole, Circulation
/// Research 24, 1969; Potse, Dube, Richer, Vinet, Gulrajani: A comparison of monodomain and bidomain
/// reaction-diffusion models, IEEE Transactions on Biomedical Engineering 53, 2006 (depth by distances).
Result<FiberReport> ComputeFibers(const VolumeMesh& mesh, const MeshPatches& patches,
                                  const FiberOptions& options, FiberField& field, Monitor& monitor);

} // namespace lamina
