// SPDX-License-Identifier: BSD-3-Clause
#include "GridAudit.h"

namespace lamina
{
namespace
{

/// Gaps and hanging nodes are looked for within this share of a mean edge.
constexpr double GapTolerance = 1e-7;

void Append(const std::vector<std::string>& from, std::vector<std::string>& to)
{
  to.insert(to.end(), from.begin(), from.end());
}

} // namespace

Result<GridAudit> AuditWholeGrid(const GridAuditInput& input, const AuditOptions& options, Monitor& monitor)
{
  GridAudit audit;
  SubMonitor first(monitor, 0, 0.6);
  auto report = AuditMesh(*input.mesh, input.surface, options, audit.marks, first);
  if (!report)
  {
    return report.GetError();
  }
  audit.report = std::move(*report);
  std::vector<Vec3> apart;
  VolumeMesh merged;
  if (!options.twins.empty())
  {
    merged = MergeTwins(*input.mesh, options.twins, apart);
  }
  const VolumeMesh& mesh = options.twins.empty() ? *input.mesh : merged;
  SubMonitor second(monitor, 0.6, 0.7);
  auto boundary = AuditBoundary(mesh, audit.marks.boundary, GapTolerance, audit.marks.flags, second);
  if (!boundary)
  {
    return boundary.GetError();
  }
  audit.boundary = std::move(*boundary);
  Append(audit.boundary.findings, audit.report.findings);
  SubMonitor third(monitor, 0.7, 0.9);
  FindPatchesOptions finding;
  finding.surfaceScale = options.surfaceScale;
  const auto found = FindPatches(mesh, input.surface, finding, audit.found, third, &audit.marks.faces);
  audit.marks.faces = {};
  if (!found)
  {
    return found.GetError();
  }
  audit.hasPatches = input.patches != nullptr;
  if (input.patches != nullptr)
  {
    audit.patches =
      AuditPatches(mesh, *input.patches, audit.found, input.surface != nullptr, audit.marks.flags);
    Append(audit.patches.findings, audit.report.findings);
  }
  if (input.surface != nullptr)
  {
    audit.sizes = AuditSizes(*input.surface);
  }
  audit.hasImage = input.image != nullptr;
  if (input.image != nullptr)
  {
    SubMonitor fourth(monitor, 0.9, 1);
    auto image = AuditAgainstImage(mesh, audit.found, *input.image, options.surfaceScale, fourth);
    if (!image)
    {
      return image.GetError();
    }
    audit.image = std::move(*image);
  }
  return audit;
}

} // namespace lamina
