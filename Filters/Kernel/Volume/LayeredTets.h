// SPDX-License-Identifier: BSD-3-Clause
// Layered tetrahedra for the solid materials of a surface.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/TriangleComplex.h"
#include "../Mesh/VolumeMesh.h"
#include "CoreTets.h"

namespace lamina
{

struct LayeredTetsOptions
{
  std::vector<int> materials; ///< the solids to mesh; empty: none
  int layers = 6;             ///< across a wall, >= 1
  double anisotropy = 2; ///< tangential edge over layer thickness: how far apart middle points stand, > 0
  double growth = 1.0;   ///< ratio of a layer to the one before it, inwards, > 0
  CoreTetsOptions core;
};

struct LayersReport
{
  Id tets = 0;
  Id wedges = 0;
  Id pyramids = 0;
  Id columns = 0;          ///< wall nodes that carry layers
  Id thinnedColumns = 0;   ///< columns thinner than asked
  Id stoppedColumns = 0;   ///< columns without layers
  Id shortenedColumns = 0; ///< columns that lost a layer to the tets' quality
  std::vector<Vec3> stoppedPlaces;
  double leastQuality = 0;
};

/// Per triangle of the surface: layers that stand on it, and the share of the asked thickness.
struct LayersOnSurface
{
  std::vector<int> achieved;
  std::vector<double> fraction;
};

/// The surface must carry thickness (see FeatureSize.h).
Result<LayersReport> MeshLayeredTets(const TriangleComplex& surface, const LayeredTetsOptions& options,
                                     VolumeMesh& mesh, LayersOnSurface& onSurface, Monitor& monitor);

} // namespace lamina
