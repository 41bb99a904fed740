// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "MeshArrayNames.h"

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lamina
{

namespace
{

std::string Number(double value)
{
  if (!std::isfinite(value))
  {
    return "null";
  }
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string Quoted(const std::string& value)
{
  std::string text = "\"";
  for (const char c : value)
  {
    if (c == '"' || c == '\\')
    {
      text += '\\';
      text += c;
    }
    else if (static_cast<unsigned char>(c) < 0x20)
    {
      text += ' ';
    }
    else
    {
      text += c;
    }
  }
  return text + "\"";
}

template<typename T, typename Write>
std::string List(const std::vector<T>& values, const Write& write)
{
  std::string text = "[";
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    text += (i == 0 ? "" : ", ") + write(values[i]);
  }
  return text + "]";
}

} // namespace

Report& Report::Put(const char* name, const std::string& json)
{
  this->Text += (this->Text.empty() ? "" : ", ") + Quoted(name) + ": " + json;
  return *this;
}

Report& Report::Add(const char* name, bool value)
{
  return this->Put(name, value ? "true" : "false");
}
Report& Report::Add(const char* name, int value)
{
  return this->Put(name, std::to_string(value));
}
Report& Report::Add(const char* name, Id value)
{
  return this->Put(name, std::to_string(value));
}
Report& Report::Add(const char* name, double value)
{
  return this->Put(name, Number(value));
}
Report& Report::Add(const char* name, const std::string& value)
{
  return this->Put(name, Quoted(value));
}
Report& Report::Add(const char* name, const std::vector<int>& values)
{
  return this->Put(name, List(values, [](int v) { return std::to_string(v); }));
}
Report& Report::Add(const char* name, const std::vector<double>& values)
{
  return this->Put(name, List(values, Number));
}
Report& Report::Add(const char* name, const std::vector<std::string>& values)
{
  return this->Put(name, List(values, Quoted));
}
Report& Report::Add(const char* name, const std::vector<Vec3>& places)
{
  constexpr std::size_t most = 100;
  std::vector<Vec3> some(places.begin(), places.begin() + static_cast<long>(std::min(places.size(), most)));
  return this->Put(name, List(some, [](const Vec3& p)
                              { return "[" + Number(p.x) + ", " + Number(p.y) + ", " + Number(p.z) + "]"; }));
}
Report& Report::Add(const char* name, const std::vector<Report>& rows)
{
  return this->Put(name, List(rows, [](const Report& row) { return row.Json(); }));
}

Report& Report::Tell(const std::string& line)
{
  this->Told = line;
  return this->Add("summary", line);
}

void AttachReport(vtkDataObject* output, const char* stage, const Report& report)
{
  vtkNew<vtkStringArray> text;
  text->SetName((std::string(names::ReportPrefix) + stage).c_str());
  text->InsertNextValue(report.Json());
  if (!report.Line().empty())
  {
    text->InsertNextValue(report.Line());
  }
  output->GetFieldData()->AddArray(text);
}

const char* SummaryOf(vtkAlgorithm* self, const char* stage)
{
  const std::string name = std::string(names::ReportPrefix) + stage;
  for (int port = 0; port < self->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = self->GetExecutive()->GetOutputData(port);
    vtkFieldData* fields = output ? output->GetFieldData() : nullptr;
    auto* text = fields ? vtkStringArray::SafeDownCast(fields->GetAbstractArray(name.c_str())) : nullptr;
    if (text && text->GetNumberOfValues() > 1)
    {
      return text->GetValue(1).c_str();
    }
  }
  return "";
}

} // namespace lamina
