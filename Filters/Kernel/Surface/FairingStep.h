// SPDX-License-Identifier: BSD-3-Clause
// The step that levels long waves, inside the bounds of a phase of smoothing.
#pragma once

#include "../Base/Monitor.h"
#include "MoveGuard.h"

#include <functional>

namespace lamina
{

/// Levels the waves of the sheets that edge relaxations, which pass volume from neighbour to neighbour only,
/// would need hundreds of sweeps for. The moves add up to no volume over half a wavelength, to first order.
/// Points of curves, of border planes, at sharp edges and where the surface curves more sharply than the
/// waves stay: so do strands and rims. A point that would leave its bounds or turn a triangle too far goes
/// less far or not at all. Returns a flag for each point that stayed: leave it out when the rest of the
/// volumes is restored.
std::vector<char> LevelWaves(SmoothingState& state, const MoveGuard& guard, double wavelength,
                             Monitor& monitor);

/// Moves the points inside the sheets along their normals, by volumes that are given for triangles (towards
/// the normal) and spread over about `distance`, as far as the guard allows.
void SpreadVolumes(SmoothingState& state, const MoveGuard& guard, const std::function<double(Id)>& volumeOf,
                   double distance, Monitor& monitor);

/// Moves all points at once; those that offend go half as far, twice, then stay, until the guard has nothing
/// to say. Flags the points that did not go all the way in `held` (one a point).
void MoveSafely(SmoothingState& state, const MoveGuard& guard, std::vector<Vec3> moves,
                std::vector<char>& held, Monitor& monitor);

} // namespace lamina
