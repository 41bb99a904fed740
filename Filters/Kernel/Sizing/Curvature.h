// SPDX-License-Identifier: BSD-3-Clause
// The principal curvatures of a surface at its points, by local polynomial fits.
#pragma once

#include "../Base/Monitor.h"
#include "../Mesh/Adjacency.h"

namespace lamina
{

/// One value a point. Positive where the surface bends away from its normal: a ball of material 1 in
/// background has 1 / radius twice.
struct Curvatures
{
  std::vector<double> maximum;
  std::vector<double> minimum;
  std::vector<Vec3> maximumDirection; ///< unit, along the surface, either way; zero at points without a fit
};

/// Fits a quadric to the sheet around each point (X. Jiao, H. Zha: Consistent computation of first- and
/// second-order differential quantities for surface meshes, Proc. ACM Solid and Physical Modeling 2008) and
/// takes normal and curvatures from the same fit. Ours are the neighbourhood, all of the sheet within about
/// three edge lengths, with weights that fall to zero at its rim; the trust in points, which falls with their
/// distance from a first fit, so that single spikes do not count; and what circles rise above parabolas,
/// which is taken off before the last fit. The offset is free: the point itself may be a spike.
///
/// A sheet ends where other than two triangles meet, or other materials or patches begin; where several
/// sheets meet each is fitted from its own side and the most curved one counts. Plane patches (any patch but
/// 0) have no fit: points of them alone get zeros. Along a crease inside a sheet the curvature is that of a
/// rounding of some edge lengths. `star`: TrianglesOfPoints of the surface.
Curvatures FitCurvatures(const TriangleComplex& surface, const Lists& star, Monitor& monitor);

} // namespace lamina
