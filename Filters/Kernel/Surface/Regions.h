// SPDX-License-Identifier: BSD-3-Clause
// The connected pieces of all materials, background among them, and moves that change their volumes.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/VolumeCorrection.h"
#include "SmoothingState.h"

namespace lamina
{

/// A graph whose shells are regions: all shells that bound one connected piece of a material, its cavities'
/// among them, as one. So are the pieces of background that the surface encloses; what lies around all (and
/// has no volume) is -1.
SheetGraph MakeRegions(const TriangleComplex& surface);

/// What the labels' repair owes to every region (TriangleComplex::missing), as volumes.
std::vector<double> MissingVolumes(const TriangleComplex& surface, const SheetGraph& regions);

/// Moves of the points that change the regions' volumes by `wanted` to first order: least in the mean square
/// over the area around the points. Points flagged in `held` stay, others keep their freedom.
std::vector<Vec3> VolumeMoves(const SmoothingState& state, const SheetGraph& regions,
                              const std::vector<double>& wanted, const std::vector<char>& held,
                              Monitor& monitor);

} // namespace lamina
