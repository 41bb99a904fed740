// SPDX-License-Identifier: BSD-3-Clause
// Between vtkPolyData and the kernel's TriangleComplex, with all arrays of the contract (docs/pipeline.md).
#pragma once

#include "Stage.h"

#include "Base/Monitor.h"
#include "Mesh/TriangleComplex.h"

class vtkPolyData;

namespace lamina
{

/// Read points, triangles and every array of the contract that is there. Cells other than triangles are
/// refused. Without BoundaryLabels, a closed surface is taken as material 1 inside and background outside
/// (PlainSurface.h).
Result<TriangleComplex> ReadSurface(vtkPolyData* input, Monitor& monitor);

/// The same for an input that may be left out: empty if it is. A failure says that the surface is meant.
Result<TriangleComplex> ReadSideSurface(vtkPolyData* input, Monitor& monitor);

/// Give `output` the surface's points and triangles, its arrays, and take away arrays of the contract it does
/// not have. Other arrays of `output` stay: fill it by ShallowCopy from the input first if they still fit.
/// ParaView shows what is active: FeatureSize, where it is known, else BoundaryLabels.
void WriteSurface(const TriangleComplex& surface, vtkPolyData* output);

/// Put LayersAchieved and LayerFraction on the triangles.
void WriteLayers(const std::vector<int>& achieved, const std::vector<double>& fraction, vtkPolyData* output);

/// A failure if the surface has no usable target edge length, which came from the array `name`: the message
/// names the filter that makes it.
Status RequireTargetEdgeLength(const TriangleComplex& surface, const char* name);
/// A failure if the surface has no MaterialFeatureSize: the message names the filter that makes it.
Status RequireThickness(const TriangleComplex& surface);

} // namespace lamina
