// SPDX-License-Identifier: BSD-3-Clause
// Prism layers on the walls of the fluid materials of a surface.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/TriangleComplex.h"
#include "../Mesh/VolumeMesh.h"
#include "LayeredTets.h"

namespace lamina
{

struct PrismLayersOptions
{
  std::vector<int> materials; ///< the fluids; empty: none
  int layers = 5;             ///< prisms on every wall triangle, >= 1
  double growth = 1.2;        ///< height of a layer over that of the one below it, in [1, 3]
  double thickness = 0.25;    ///< of all layers together, as a share of the local feature size, in (0, 0.45]
  double total = 0;           ///< of all layers together, a length, instead of the share; 0: by the share
  double firstHeight = 0;     ///< of the first layer, a length, instead of both; 0: not fixed
  /// Prisms are better, or the columns under them stop, where the wall's points are seen well and its
  /// triangles are good.
  double leastQuality = 0.2;
  /// Columns may stop; if not, it is an error with the places.
  bool endColumns = true;
  std::vector<int> neighbours; ///< materials (0 the outside) whose walls carry prisms; empty: all
  std::vector<int> patches;    ///< patches of the surface that do (0: walls of no other); empty: all
};

/// A length that is asked for is kept where it is at most 0.45 of the local thickness, else cut to that.
/// `mesh` gets the prisms (pyramids and tets where columns had to stop: at openings, at walls not chosen, and
/// at nodes that no direction sees); `front` the closed surfaces that bound what is left, materials (fluid,
/// 0).
Result<LayersReport> GrowPrismLayers(const TriangleComplex& surface, const PrismLayersOptions& options,
                                     VolumeMesh& mesh, TriangleComplex& front, LayersOnSurface& onSurface,
                                     Monitor& monitor);

} // namespace lamina
