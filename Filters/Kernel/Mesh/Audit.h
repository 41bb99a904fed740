// SPDX-License-Identifier: BSD-3-Clause
// The audit of a volume mesh: conformity, orientation, overlap, volumes, quality. Also used by the tests.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "CellFaces.h"
#include "TriangleComplex.h"
#include "VolumeMesh.h"

#include <limits>
#include <map>

namespace lamina
{

struct AuditOptions
{
  double qualityGate = 0.1;      ///< 3r/R below which a tet counts as bad
  double volumeTolerance = 1e-9; ///< relative difference allowed between cells and enclosed volume
  Id overlapSamples = 2000;      ///< random points tested for lying in exactly one cell
  double surfaceScale = 1;       ///< factor on `surface`'s coordinates to match the mesh
  /// One a point: the coincident node on the other side of an interface, -1 for none. Empty: nodes are
  /// shared.
  std::vector<Id> twins;
};

/// Bits of MeshingFlags set by the audit on cells.
enum AuditFlag : unsigned char
{
  FlagInverted = 1,
  FlagBadQuality = 2,
  FlagNonConforming = 4,
  FlagOverlap = 8
};

/// Quality of the cells of one type: tets 3r/R, wedges scaled aspect ratio, pyramids of their worst half.
struct QualityAudit
{
  CellType type = CellType::Tetrahedron;
  Id count = 0;
  double least = 1;
  std::array<double, 5> percentiles{ { 1, 1, 1, 1, 1 } }; ///< 1, 5, 25, 50, 95
  std::array<Id, 20> histogram{}; ///< of [0, 1] in steps of 0.05; below 0 counts in the first
};

/// A cell to look at.
struct WorstCell
{
  Id cell = -1;
  CellType type = CellType::Tetrahedron;
  int material = 0;
  double quality = 1;
  Vec3 place; ///< its middle
};

struct MaterialAudit
{
  int material = 0;
  Id tets = 0;
  Id wedges = 0;
  Id pyramids = 0;
  Id components = 0; ///< pieces connected through faces
  double meshVolume = 0;
  double surfaceVolume = 0; ///< NaN without a surface
  /// Of its voxels in the image: not known to the audit, for those who hand it on. NaN: not known at all.
  double imageVolume = std::numeric_limits<double>::quiet_NaN();
  double tetQualityMin = 1; ///< 3r/R
  double tetQualityP1 = 1;  ///< percentiles 1 and 50
  double tetQualityP50 = 1;
  double tetAboveGate = 1;    ///< share of tets above the gate
  double wedgeQualityMin = 1; ///< scaled aspect ratio
  double wedgeQualityP1 = 1;
  double wedgeQualityP50 = 1;
  std::vector<QualityAudit> qualities; ///< one a type that occurs
  std::map<int, Id> cellsOfLayer;      ///< by LayerIds, 0 the core
};

struct AuditReport
{
  Id points = 0;
  Id cells = 0;
  Id invertedCells = 0;
  Id facesOfManyCells = 0; ///< interior faces shared by more than two cells
  Id mismatchedFaces = 0;  ///< quads that meet triangles
  Id duplicateCells = 0;   ///< with the nodes of another
  Id duplicatePoints = 0;
  Id twinMismatches = 0; ///< twins that do not lie in the same place, or are not each other's
  Id unusedPoints = 0;
  Id openFaces = 0; ///< boundary faces that are not triangles of the surface (needs the surface)
  Id strayInterfaces =
    0; ///< faces between two materials that are not triangles of the surface (needs the surface)
  Id interfaceTriangles = 0; ///< surface triangles between meshed materials
  Id interfaceMismatches =
    0;                   ///< surface triangles between meshed materials without exactly one cell on each side
  Id wallMismatches = 0; ///< surface triangles on one meshed material without exactly one cell, on its side
  Id overlaps = 0;       ///< sample points in more than one cell, or in none where the surface says inside
  double largestVolumeError = 0; ///< relative
  /// The certificate of the surface that the mesh was made from, where it has travelled along: not tested
  /// here. NaN: not known.
  double carriedPairs = std::numeric_limits<double>::quiet_NaN();
  double carriedClearance = std::numeric_limits<double>::quiet_NaN();
  double carriedAngle = std::numeric_limits<double>::quiet_NaN();
  std::vector<MaterialAudit> materials;
  std::vector<WorstCell> worst; ///< the ten of the least quality of each type
  std::map<int, Id>
    stackHeights; ///< prisms above a wall triangle -> number of such triangles: layers achieved
  std::vector<std::string> findings; ///< a sentence for each thing wrong, with the first places
  bool Passed() const { return this->findings.empty(); }
};

/// What the audit writes on the cells.
struct AuditMarks
{
  std::vector<double> quality;      ///< MeshQuality
  std::vector<unsigned char> flags; ///< MeshingFlags
  std::vector<CellFace> boundary;   ///< faces of one cell only
  CellFaces faces;                  ///< all, for who goes on from here
};

/// Audit `mesh`; with `surface` (may be null) also interfaces and enclosed volumes.
Result<AuditReport> AuditMesh(const VolumeMesh& mesh, const TriangleComplex* surface,
                              const AuditOptions& options, AuditMarks& marks, Monitor& monitor);

/// The mesh as if twins were one node: the lower id stands for both where they lie in one place, bit for bit.
/// `mismatches` gets the places where they do not, or are not each other's.
VolumeMesh MergeTwins(const VolumeMesh& mesh, const std::vector<Id>& twins, std::vector<Vec3>& mismatches);

} // namespace lamina
