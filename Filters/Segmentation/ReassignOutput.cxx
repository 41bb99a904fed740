// SPDX-License-Identifier: BSD-3-Clause
#include "ReassignOutput.h"

#include "Arrays.h"
#include "MeshArrayNames.h"

#include "Base/Text.h"

#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>

#include <initializer_list>

namespace lamina
{

Report Describe(const ReassignReport& report)
{
  std::vector<Report> edits;
  for (const EditReport& edit : report.edits)
  {
    edits.emplace_back();
    edits.back()
      .Add("edit", edit.name)
      .Add("shape", ShapeName(edit.shape))
      .Add("material", edit.to)
      .Add("covered", edit.covered)
      .Add("decided", edit.decided)
      .Add("changed", edit.changed);
  }
  Id changed = static_cast<Id>(report.repaired.size());
  for (const EditReport& edit : report.edits)
  {
    changed += edit.changed;
  }
  return Report()
    .Tell(Amount(static_cast<Id>(report.edits.size()), "edit") + ", " + Amount(changed, "voxel") +
          " changed, " + Amount(report.remaining, "fault") + " left")
    .Add("edits", edits)
    .Add("criticalEdges", report.criticalEdges)
    .Add("criticalCorners", report.criticalCorners)
    .Add("forbiddenContacts", report.forbiddenContacts)
    .Add("repaired", static_cast<Id>(report.repaired.size()))
    .Add("overridden", report.overridden)
    .Add("overriddenAt", report.overriddenAt)
    .Add("remaining", report.remaining)
    .Add("warnings", report.warnings);
}

void FillTable(const ReassignReport& report, vtkTable* table)
{
  vtkNew<vtkStringArray> steps;
  vtkNew<vtkStringArray> shapes;
  vtkNew<vtkIntArray> materials;
  vtkNew<vtkIdTypeArray> covered;
  vtkNew<vtkIdTypeArray> decided;
  vtkNew<vtkIdTypeArray> changed;
  steps->SetName("Step");
  shapes->SetName("Shape");
  materials->SetName("Material");
  covered->SetName("Covered");
  decided->SetName("Decided");
  changed->SetName("Changed");
  const auto add =
    [&](const std::string& step, const char* shape, int material, const std::array<Id, 3>& counts)
  {
    steps->InsertNextValue(step);
    shapes->InsertNextValue(shape);
    materials->InsertNextValue(material);
    covered->InsertNextValue(counts[0]);
    decided->InsertNextValue(counts[1]);
    changed->InsertNextValue(counts[2]);
  };
  for (const EditReport& edit : report.edits)
  {
    add(edit.name, ShapeName(edit.shape), edit.to, { { edit.covered, edit.decided, edit.changed } });
  }
  if (report.mended)
  {
    const Id repaired = static_cast<Id>(report.repaired.size());
    add("repair", "", -1, { { repaired, repaired - report.overridden, repaired } });
    add("repair of edited voxels", "", -1, { { report.overridden, report.overridden, report.overridden } });
  }
  for (vtkAbstractArray* column :
       std::initializer_list<vtkAbstractArray*>{ steps, shapes, materials, covered, decided, changed })
  {
    table->AddColumn(column);
  }
}

void UpdateDisputed(const std::vector<unsigned char>& decisions, vtkImageData* output)
{
  vtkDataArray* old = output->GetPointData()->GetArray(names::Disputed);
  if (!old || old->GetNumberOfComponents() != 1)
  {
    return;
  }
  std::vector<unsigned char> disputed(decisions.size());
  for (std::size_t v = 0; v < decisions.size(); ++v)
  {
    const bool before = old->GetComponent(static_cast<vtkIdType>(v), 0) != 0;
    disputed[v] = decisions[v] == Untouched ? before : decisions[v] == Overridden;
  }
  output->GetPointData()->AddArray(MakeArray<vtkUnsignedCharArray>(names::Disputed, disputed));
}

} // namespace lamina
