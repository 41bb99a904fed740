// SPDX-License-Identifier: BSD-3-Clause
// All that the audit of a grid does, and what it found.
#pragma once

#include "Base/Monitor.h"
#include "Mesh/Audit.h"
#include "Mesh/AuditPatches.h"
#include "Mesh/LabelImage.h"
#include "Surface/AuditBoundary.h"
#include "Surface/AuditImage.h"
#include "Surface/AuditSizes.h"

namespace lamina
{

/// What is audited besides the mesh; null where it is not there.
struct GridAuditInput
{
  const VolumeMesh* mesh = nullptr;
  const TriangleComplex* surface = nullptr;
  const LabelImage* image = nullptr;
  const MeshPatches* patches = nullptr;
};

struct GridAudit
{
  AuditReport report; ///< its findings are those of all parts
  AuditMarks marks;
  BoundaryAudit boundary;
  PatchAudit patches;
  MeshPatches found; ///< the patches with areas: the grid's own, else found anew
  SizeAudit sizes;
  ImageAudit image;
  bool hasPatches = false;
  bool hasImage = false;
};

Result<GridAudit> AuditWholeGrid(const GridAuditInput& input, const AuditOptions& options, Monitor& monitor);

} // namespace lamina
