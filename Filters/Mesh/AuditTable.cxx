// SPDX-License-Identifier: BSD-3-Clause
#include "AuditTable.h"

#include "AuditFigures.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <limits>

namespace lamina
{

namespace
{

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

void FillTable(const GridAudit& audit, vtkTable* table)
{
  Fill(audit.report, FurtherFigures(audit), table);
}

void FillTable(const SurfaceAuditReport& report, vtkTable* table)
{
  Fill(report, {}, table);
}

} // namespace lamina
