// SPDX-License-Identifier: BSD-3-Clause
// The improvement of a solid's layers and core together.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/VolumeMesh.h"
#include "ImproveTets.h"

namespace lamina
{

/// Better tets among the cells from firstCell on, across the seam of layers and core; the wall stays, and no
/// edge may skip a layer. All points after the solid's wall must be the solid's own: those that are taken out
/// leave the mesh. `columnLayers` layers stand on the walls; the rest is core. The report's ids are those of
/// the mesh before points left it.
ImproveTetsReport ImproveLayers(VolumeMesh& mesh, std::size_t firstCell, int columnLayers, Monitor& monitor);

} // namespace lamina
