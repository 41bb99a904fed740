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
           { "duplicatePoints", n(r.duplicatePoints) },
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
  }
  return report.Add("materials", rows).Add("findings", audit.findings);
}

template<typename AuditT>
void Fill(const AuditT& audit, vtkTable* table)
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
  for (const auto& [name, value] : FiguresOf(audit))
  {
    add(name, all, value, "");
  }
  for (const auto& material : audit.materials)
  {
    for (const auto& [name, value] : FiguresOf(material))
    {
      add(name, material.material, value, "");
    }
  }
  for (vtkAbstractArray* column : std::initializer_list<vtkAbstractArray*>{ names, materials, values, texts })
  {
    table->AddColumn(column);
  }
}

} // namespace

Report DescribeAudit(const AuditReport& report)
{
  return Describe(report);
}

Report DescribeAudit(const SurfaceAuditReport& report)
{
  return Describe(report);
}

void FillTable(const AuditReport& report, vtkTable* table)
{
  Fill(report, table);
}

void FillTable(const SurfaceAuditReport& report, vtkTable* table)
{
  Fill(report, table);
}

} // namespace lamina
