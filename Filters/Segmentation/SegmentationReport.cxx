// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentationReport.h"

#include "Base/Text.h"

#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

namespace lamina
{

namespace
{

std::vector<Report> Rows(const std::vector<BettiNumbers>& materials)
{
  std::vector<Report> rows;
  for (const BettiNumbers& material : materials)
  {
    rows.emplace_back();
    rows.back()
      .Add("material", material.material)
      .Add("voxels", material.voxels)
      .Add("components", material.b0)
      .Add("tunnels", material.b1)
      .Add("cavities", material.b2);
  }
  return rows;
}

/// "thresholds 50.9, 127, 148; material 1: 60.1 k voxels in 1 piece; ...; 512 voxels disputed, 0 faults
/// left".
std::string LineOf(const SegmentReport& report)
{
  std::string line = "thresholds ";
  for (std::size_t t = 0; t < report.thresholds.size(); ++t)
  {
    line += (t == 0 ? "" : ", ") + Short(report.thresholds[t]);
  }
  constexpr int most = 3;
  int told = 0;
  for (const BettiNumbers& material : report.after)
  {
    if (material.material > 0 && material.voxels > 0 && ++told <= most)
    {
      line += "; material " + std::to_string(material.material) + ": " + Amount(material.voxels, "voxel") +
              " in " + Amount(material.b0, "piece");
    }
  }
  line += told > most ? "; " + Amount(told - most, "more material") : "";
  return line + "; " + Amount(report.disputed, "voxel") + " disputed, " +
         Amount(report.topology.remaining, "fault") + " left";
}

} // namespace

Report Describe(const SegmentReport& report)
{
  std::vector<Report> rules;
  for (const SegmentRule& rule : report.rules)
  {
    rules.emplace_back();
    rules.back()
      .Add("rule", rule.name)
      .Add("material", rule.material)
      .Add("components", rule.components)
      .Add("voxels", rule.voxels);
  }
  const SegmentTopology& faults = report.topology;
  return Report()
    .Add("rules", rules)
    .Add("materials", Rows(report.after))
    .Add("materialsBefore", Rows(report.before))
    .Add("thresholds", report.thresholds)
    .Add("modes", report.modes)
    .Add("least", report.least)
    .Add("greatest", report.greatest)
    .Add("noise", report.noise)
    .Add("disputed", report.disputed)
    .Add("passes", report.passes)
    .Add("criticalEdges", faults.criticalEdges)
    .Add("criticalCorners", faults.criticalCorners)
    .Add("forbiddenContacts", faults.forbiddenContacts)
    .Add("repairedVoxels", faults.changed)
    .Add("faultsLeft", faults.remaining)
    .Add("warnings", report.warnings)
    .Tell(LineOf(report));
}

namespace
{

/// The columns of the report. What a row does not speak of is 0.
class Table
{
public:
  void Add(const std::string& rule, const BettiNumbers& material)
  {
    this->Rules->InsertNextValue(rule);
    this->Materials->InsertNextValue(material.material);
    const Id counts[4] = { material.voxels, material.b0, material.b1, material.b2 };
    for (std::size_t c = 0; c < 4; ++c)
    {
      this->Counts[c]->InsertNextValue(counts[c]);
    }
  }
  void MoveTo(vtkTable* table)
  {
    const char* names[4] = { "Voxels", "Components", "Tunnels", "Cavities" };
    this->Rules->SetName("Rule");
    this->Materials->SetName("Material");
    table->AddColumn(this->Rules);
    table->AddColumn(this->Materials);
    for (const std::size_t c : { 1, 0, 2, 3 })
    {
      this->Counts[c]->SetName(names[c]);
      table->AddColumn(this->Counts[c]);
    }
  }

private:
  vtkNew<vtkStringArray> Rules;
  vtkNew<vtkIntArray> Materials;
  vtkNew<vtkIdTypeArray> Counts[4];
};

} // namespace

void FillTable(const SegmentReport& report, vtkTable* output)
{
  Table table;
  for (const BettiNumbers& material : report.before)
  {
    table.Add("after the thresholds", material);
  }
  for (const SegmentRule& rule : report.rules)
  {
    table.Add(rule.name, { rule.material, rule.voxels, rule.components, 0, 0 });
  }
  const SegmentTopology& faults = report.topology;
  table.Add("faults found: contacts over an edge", { 0, faults.criticalEdges, 0, 0, 0 });
  table.Add("faults found: contacts over a corner", { 0, faults.criticalCorners, 0, 0, 0 });
  table.Add("faults found: forbidden contacts", { 0, faults.forbiddenContacts, 0, 0, 0 });
  table.Add("faults left", { 0, faults.remaining, 0, 0, 0 });
  for (const BettiNumbers& material : report.after)
  {
    table.Add("in all", material);
  }
  table.MoveTo(output);
}

} // namespace lamina
