// SPDX-License-Identifier: BSD-3-Clause
#include "AuditTable.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <limits>
#include <utility>

namespace lamina
{

namespace
{

using Figures = std::vector<std::pair<const char*, double>>;

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

/// Figures of the parts besides the mesh itself.
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

const char* TypeName(CellType type)
{
  return type == CellType::Tetrahedron ? "tetrahedra" : (type == CellType::Wedge ? "wedges" : "pyramids");
}

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

/// Rows of a kind of cell: its least quality and percentiles.
template<typename Add>
void AddQualities(const MaterialSurfaceAudit&, const Add&)
{
}
template<typename Add>
void AddQualities(const MaterialAudit& material, const Add& add)
{
  const char* const names[] = { "P1", "P5", "P25", "P50", "P95" };
  for (const QualityAudit& q : material.qualities)
  {
    add(std::string(TypeName(q.type)) + "Least", material.material, q.least, "");
    for (std::size_t k = 0; k < q.percentiles.size(); ++k)
    {
      add(std::string(TypeName(q.type)) + names[k], material.material, q.percentiles[k], "");
    }
  }
  for (const auto& [layer, count] : material.cellsOfLayer)
  {
    add("cellsOfLayer" + std::to_string(layer), material.material, static_cast<double>(count), "");
  }
}

template<typename AuditT>
void Fill(const AuditT& audit, const Figures& further, vtkTable* table)
{
  constexpr int all = -1;
  vtkNew<vtkStringArray> names;
  vtkNew<vtkIntArray> materials;
  vtkNew<vtkDoubleArray> values;
  vtkNew<vtkStringArray> texts;
  names->SetName("Name");
  materials->SetName("Material");
  values->SetName("Value");
  texts->SetName("Text");
  const auto add = [&](const std::string& name, int material, double value, const std::string& text)
  {
    names->InsertNextValue(name);
    materials->InsertNextValue(material);
    values->InsertNextValue(value);
    texts->InsertNextValue(text);
  };
  add("passed", all, audit.Passed() ? 1 : 0, audit.Passed() ? "nothing wrong was found" : "see the findings");
  for (const std::string& finding : audit.findings)
  {
    add("finding", all, std::numeric_limits<double>::quiet_NaN(), finding);
  }
  for (const Figures& figures : { FiguresOf(audit), further })
  {
    for (const auto& [name, value] : figures)
    {
      add(name, all, value, "");
    }
  }
  for (const auto& material : audit.materials)
  {
    for (const auto& [name, value] : FiguresOf(material))
    {
      add(name, material.material, value, "");
    }
    AddQualities(material, add);
  }
  for (vtkAbstractArray* column : std::initializer_list<vtkAbstractArray*>{ names, materials, values, texts })
  {
    table->AddColumn(column);
  }
}

} // namespace

Report DescribeAudit(const GridAudit& audit)
{
  Report report = Describe(audit.report);
  AddFigures(report, FurtherFigures(audit));
  report.Add("layersAchieved", DescribeCounts(audit.report.stackHeights, "prisms"));
  report.Add("worstCells", DescribeWorst(audit.report)).Add("patches", DescribePatches(audit.found));
  if (audit.hasImage)
  {
    report.Add("image", std::vector<Report>{ DescribeImage(audit.image) });
  }
  return report;
}

Report DescribeAudit(const SurfaceAuditReport& report)
{
  return Describe(report);
}

void FillTable(const GridAudit& audit, vtkTable* table)
{
  Fill(audit.report, FurtherFigures(audit), table);
}

void FillTable(const SurfaceAuditReport& report, vtkTable* table)
{
  Fill(report, {}, table);
}

} // namespace lamina
