// SPDX-License-Identifier: BSD-3-Clause
// What surfaces tell of themselves in their field data.
#pragma once

#include "Surface/Certificate.h"

#include <vector>

class vtkPolyData;

namespace lamina
{

/// IntersectingPairs, LeastClearance and LeastAngle of the surface as it is.
void WriteCertificate(const SurfaceCertificate& certificate, vtkPolyData* output);

/// ImageVolumes: a tuple (material, volume of its voxels) for each material.
void WriteImageVolumes(const std::vector<int>& materials, const std::vector<double>& volumes,
                       vtkPolyData* output);

/// Take these away from a surface that is no longer the one they tell of.
void DropSurfaceFigures(vtkPolyData* output);

} // namespace lamina
