// SPDX-License-Identifier: BSD-3-Clause
#include "AuditFigures.h"

namespace lamina
{

Figures FiguresOf(const AuditReport& r)
{
  const auto n = [](Id count) { return static_cast<double>(count); };
  return { { "points", n(r.points) },
           { "cells", n(r.cells) },
           { "invertedCells", n(r.invertedCells) },
           { "facesOfManyCells", n(r.facesOfManyCells) },
           { "mismatchedFaces", n(r.mismatchedFaces) },
           { "duplicateCells", n(r.duplicateCells) },
           { "duplicatePoints", n(r.duplicatePoints) },
           { "twinMismatches", n(r.twinMismatches) },
           { "unusedPoints", n(r.unusedPoints) },
           { "openFaces", n(r.openFaces) },
           { "interfaceTriangles", n(r.interfaceTriangles) },
           { "interfaceMismatches", n(r.interfaceMismatches) },
           { "overlaps", n(r.overlaps) },
           { "largestVolumeError", r.largestVolumeError },
           { "surfaceIntersectingPairs", r.carriedPairs },
           { "surfaceLeastClearance", r.carriedClearance },
           { "surfaceLeastAngle", r.carriedAngle } };
}

Figures FiguresOf(const MaterialAudit& m)
{
  const auto n = [](Id count) { return static_cast<double>(count); };
  return { { "tets", n(m.tets) },
           { "wedges", n(m.wedges) },
           { "pyramids", n(m.pyramids) },
           { "components", n(m.components) },
           { "meshVolume", m.meshVolume },
           { "surfaceVolume", m.surfaceVolume },
           { "imageVolume", m.imageVolume },
           { "againstImage", m.meshVolume / m.imageVolume - 1 },
           { "tetQualityMin", m.tetQualityMin },
           { "tetQualityP1", m.tetQualityP1 },
           { "tetQualityP50", m.tetQualityP50 },
           { "tetAboveGate", m.tetAboveGate },
           { "wedgeQualityMin", m.wedgeQualityMin },
           { "wedgeQualityP1", m.wedgeQualityP1 },
           { "wedgeQualityP50", m.wedgeQualityP50 } };
}

Figures FurtherFigures(const GridAudit& audit)
{
  const auto n = [](Id count) { return static_cast<double>(count); };
  Figures all = { { "gapPoints", n(audit.boundary.gapPoints) },
                  { "hangingPoints", n(audit.boundary.hangingPoints) } };
  if (audit.hasPatches)
  {
    all.insert(all.end(), { { "wrongPatchFaces", n(audit.patches.wrongFaces) },
                            { "missingPatchFaces", n(audit.patches.missingFaces) },
                            { "repeatedPatchFaces", n(audit.patches.repeatedFaces) },
                            { "openPatchEdges", n(audit.patches.openEdges) },
                            { "swappedPatches", n(audit.patches.swappedPatches) } });
  }
  if (audit.sizes.edges > 0)
  {
    all.insert(all.end(), { { "sizedEdges", n(audit.sizes.edges) },
                            { "lengthOverTargetP1", audit.sizes.percentiles[0] },
                            { "lengthOverTargetP50", audit.sizes.percentiles[2] },
                            { "lengthOverTargetP99", audit.sizes.percentiles[4] },
                            { "edgesNearTarget", audit.sizes.share } });
  }
  if (audit.hasImage)
  {
    all.insert(all.end(), { { "largestVoxelVolumeError", audit.image.largestMaterialError },
                            { "largestPieceVolumeError", audit.image.largestPieceError } });
  }
  return all;
}

Figures FiguresOf(const SurfaceAuditReport& r)
{
  const auto n = [](Id count) { return static_cast<double>(count); };
  return { { "points", n(r.points) },
           { "triangles", n(r.triangles) },
           { "flatTriangles", n(r.flatTriangles) },
           { "duplicatePoints", n(r.duplicatePoints) },
           { "unusedPoints", n(r.unusedPoints) },
           { "intersectingPairs", n(r.intersectingPairs) },
           { "leastClearance", r.leastClearance },
           { "leastAngle", r.leastAngle } };
}

Figures FiguresOf(const MaterialSurfaceAudit& m)
{
  return { { "triangles", static_cast<double>(m.triangles) },
           { "openEdges", static_cast<double>(m.openEdges) },
           { "surfaceVolume", m.volume },
           { "imageVolume", m.imageVolume },
           { "againstImage", m.volume / m.imageVolume - 1 } };
}

const char* TypeName(CellType type)
{
  return type == CellType::Tetrahedron ? "tetrahedra" : (type == CellType::Wedge ? "wedges" : "pyramids");
}

} // namespace lamina
