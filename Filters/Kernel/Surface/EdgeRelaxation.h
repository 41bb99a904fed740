// SPDX-License-Identifier: BSD-3-Clause
// One relaxation of a surface edge (or of a lone point) that changes no material's volume.
#pragma once

#include "SmoothingState.h"

namespace lamina
{

/// Where the two ends of an edge go. For a lone point `b` is -1.
struct Relaxation
{
  Id a = -1;
  Id b = -1;
  Vec3 moveA;
  Vec3 moveB;
};

/// The relaxation of edge (a, b), or of point a alone where b is -1: the simultaneous Laplacian move of both
/// ends (along the curve for points of a junction curve), scaled by `weight`, plus the least common
/// translation that keeps the volume of every material around exactly. For two materials this is Algorithm 4,
/// on a triple line Algorithm 6 of Kuprat, Khamayseh, George and Larkey (J. Comput. Phys. 172, 2001); here
/// one formula serves any number of materials. Where no common translation does, as on curves of four
/// materials and more, the two ends move on their own by the least that does. Returns false where the
/// conditions cannot be met by small moves.
bool RelaxEdge(const SmoothingState& state, Id a, Id b, double weight, Relaxation& relaxation);

} // namespace lamina
