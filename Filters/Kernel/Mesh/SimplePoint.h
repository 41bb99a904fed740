// SPDX-License-Identifier: BSD-3-Clause
// Topological numbers of a voxel: what happens to a set of voxels around it when it joins or leaves the set.
#pragma once

namespace lamina
{

/// A set of voxels of a 3x3x3 block, bit i + 3 j + 9 k; the voxel at the centre (bit 13) does not count.
using Neighbourhood = unsigned;

/// The number of pieces of the set, over corners, that touch the centre: 0 it stands alone, 1 it changes no
/// connection, 2 or more it joins pieces. (The topological number for 26-connected sets of Bertrand and
/// Malandain, A new characterization of three-dimensional simple points, Pattern Recognition Letters 15,
/// 1994.)
int PiecesOverCorners(Neighbourhood set);

/// The same over faces: pieces, within the 18 voxels around the centre, that share a face with it.
int PiecesOverFaces(Neighbourhood set);

} // namespace lamina
