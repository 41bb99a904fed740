// SPDX-License-Identifier: BSD-3-Clause
// Where layers made tets that are too poor.
#pragma once

#include "../Mesh/VolumeMesh.h"
#include "Wall.h"

namespace lamina
{

/// The wall's nodes, ascending, on which layers stand that tets of 3r/R up to about 0.1 touch: of each such
/// tet's points of layers the nearest of its wall nodes. Of the cells from firstCell on, all tets; `least`
/// becomes the least 3r/R of them.
std::vector<Id> ColumnsOfPoor(const VolumeMesh& mesh, std::size_t firstCell, const Wall& wall, double& least);

/// The least 3r/R of a mesh of tets, 1 if it has none.
double LeastQuality(const VolumeMesh& mesh);

} // namespace lamina
