// SPDX-License-Identifier: BSD-3-Clause
#include "AuditFigures.h"
#include "AuditTable.h"

#include "Base/Text.h"

#include <algorithm>

namespace lamina
{

namespace
{

std::vector<double> Doubles(const std::array<Id, 20>& counts)
{
  return { counts.begin(), counts.end() };
}

std::vector<Report> DescribeQualities(const MaterialAudit& material)
{
  std::vector<Report> rows;
  for (const QualityAudit& q : material.qualities)
  {
    rows.emplace_back();
    rows.back().Add("type", TypeName(q.type)).Add("count", q.count).Add("least", q.least);
    rows.back().Add("percentiles", std::vector<double>(q.percentiles.begin(), q.percentiles.end()));
    rows.back().Add("histogram", Doubles(q.histogram));
  }
  return rows;
}

std::vector<Report> DescribeCounts(const std::map<int, Id>& counts, const char* key)
{
  std::vector<Report> rows;
  for (const auto& [value, count] : counts)
  {
    rows.emplace_back();
    rows.back().Add(key, value).Add("count", count);
  }
  return rows;
}

std::vector<Report> DescribeWorst(const AuditReport& report)
{
  std::vector<Report> rows;
  for (const WorstCell& cell : report.worst)
  {
    rows.emplace_back();
    rows.back().Add("cell", cell.cell).Add("type", TypeName(cell.type)).Add("material", cell.material);
    rows.back().Add("quality", cell.quality);
    rows.back().Add("place", std::vector<double>{ cell.place.x, cell.place.y, cell.place.z });
  }
  return rows;
}

std::vector<Report> DescribePieces(const std::vector<PieceVolume>& pieces)
{
  std::vector<Report> rows;
  for (const PieceVolume& piece : pieces)
  {
    rows.emplace_back();
    rows.back().Add("material", piece.material).Add("voxels", piece.voxels);
    rows.back().Add("voxelVolume", piece.voxelVolume).Add("meshVolume", piece.meshVolume);
  }
  return rows;
}

Report DescribeImage(const ImageAudit& image)
{
  std::vector<Report> distances;
  for (const InterfaceDistance& d : image.interfaces)
  {
    distances.emplace_back();
    distances.back()
      .Add("materials", std::vector<int>{ d.pair.first, d.pair.second })
      .Add("median", d.median);
    distances.back().Add("p95", d.p95).Add("largest", d.largest).Add("withinHalfVoxel", d.within);
  }
  Report report;
  report.Add("materials", DescribePieces(image.materials)).Add("pieces", DescribePieces(image.pieces));
  return report.Add("distancesInVoxels", distances);
}

std::vector<Report> DescribePatches(const MeshPatches& patches)
{
  std::vector<Report> rows;
  for (const MeshPatch& patch : patches.patches)
  {
    rows.emplace_back();
    rows.back().Add("name", patch.name).Add("faces", patch.faces).Add("area", patch.area);
  }
  return rows;
}

void AddFigures(Report& report, const Figures& figures)
{
  for (const auto& [name, value] : figures)
  {
    report.Add(name, value);
  }
}

void AddFurther(Report&, const MaterialSurfaceAudit&)
{
}
void AddFurther(Report& row, const MaterialAudit& material)
{
  row.Add("qualities", DescribeQualities(material));
  row.Add("layers", DescribeCounts(material.cellsOfLayer, "layer"));
}

template<typename AuditT>
Report Describe(const AuditT& audit)
{
  Report report;
  report.Add("passed", audit.Passed());
  AddFigures(report, FiguresOf(audit));
  std::vector<Report> rows;
  for (const auto& material : audit.materials)
  {
    rows.emplace_back();
    rows.back().Add("material", material.material);
    AddFigures(rows.back(), FiguresOf(material));
    AddFurther(rows.back(), material);
  }
  return report.Add("materials", rows).Add("findings", audit.findings);
}

} // namespace

namespace
{

/// "sound: 1.2 M cells, worst 0.14", or how much is wrong and the first of it.
template<typename AuditT>
std::string Verdict(const AuditT& audit, const std::string& counts)
{
  return audit.Passed() ? "sound: " + counts
                        : "NOT sound, " + Amount(static_cast<Id>(audit.findings.size()), "finding") + ": " +
                            audit.findings.front() + "; " + counts;
}

std::string CellsAndWorst(const AuditReport& report)
{
  std::string text = Amount(report.cells, "cell") + ", " + Amount(report.points, "point");
  if (!report.worst.empty())
  {
    const auto least =
      std::min_element(report.worst.begin(), report.worst.end(),
                       [](const WorstCell& a, const WorstCell& b) { return a.quality < b.quality; });
    text += ", worst " + Short(least->quality);
  }
  return text;
}

} // namespace

Report DescribeAudit(const GridAudit& audit)
{
  Report report = Describe(audit.report);
  AddFigures(report, FurtherFigures(audit));
  report.Add("layersAchieved", DescribeCounts(audit.report.stackHeights, "prisms"));
  report.Add("worstCells", DescribeWorst(audit.report)).Add("patches", DescribePatches(audit.found));
  report.Tell(Verdict(audit.report, CellsAndWorst(audit.report)));
  if (audit.hasImage)
  {
    report.Add("image", std::vector<Report>{ DescribeImage(audit.image) });
  }
  return report;
}

Report DescribeAudit(const SurfaceAuditReport& report)
{
  return Describe(report).Tell(Verdict(report, Amount(report.triangles, "triangle")));
}

} // namespace lamina
