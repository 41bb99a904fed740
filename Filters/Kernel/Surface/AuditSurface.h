// SPDX-License-Identifier: BSD-3-Clause
// The audit of a surface between materials: is each material's boundary closed and oriented, free of
// intersections, and is every point used once.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/TriangleComplex.h"

#include <limits>

namespace lamina
{

struct MaterialSurfaceAudit
{
  int material = 0;
  Id triangles = 0;
  Id openEdges = 0;  ///< edges through which its triangles do not run equally often in both directions
  double volume = 0; ///< enclosed, by the divergence theorem
  /// Of its voxels in the image: not known to the audit, for those who hand it on. NaN: not known at all.
  double imageVolume = std::numeric_limits<double>::quiet_NaN();
};

struct SurfaceAuditReport
{
  Id points = 0;
  Id triangles = 0;
  Id flatTriangles = 0;   ///< without an area
  Id duplicatePoints = 0; ///< equal to another point, bit for bit
  Id unusedPoints = 0;
  double leastClearance = 0; ///< as in SurfaceCertificate
  double leastAngle = 0;     ///< degrees
  Id intersectingPairs = 0;  ///< pairs of triangles that meet anywhere but in shared corners and edges
  std::vector<MaterialSurfaceAudit> materials; ///< ascending, background apart
  std::vector<std::string> findings;           ///< a sentence for each thing wrong, with the first places
  bool Passed() const { return this->findings.empty(); }
};

/// Audit `surface`; `flags` gets MeshingFlags of the triangles (Audit.h): FlagBadQuality for flat ones,
/// FlagNonConforming at an open edge, FlagOverlap for those that intersect another.
Result<SurfaceAuditReport> AuditSurface(const TriangleComplex& surface, std::vector<unsigned char>& flags,
                                        Monitor& monitor);

} // namespace lamina
