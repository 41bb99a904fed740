// SPDX-License-Identifier: BSD-3-Clause
// What a stage has to tell, as JSON text that travels with its output.
#pragma once

#include "Base/Types.h"

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;

namespace lamina
{

/// An object of JSON in the making. Numbers that are not finite become null.
class Report
{
public:
  Report& Add(const char* name, bool value);
  Report& Add(const char* name, int value);
  Report& Add(const char* name, Id value);
  Report& Add(const char* name, double value);
  Report& Add(const char* name, const std::string& value);
  Report& Add(const char* name, const char* value) { return this->Add(name, std::string(value)); }
  Report& Add(const char* name, const std::vector<int>& values);
  Report& Add(const char* name, const std::vector<double>& values);
  Report& Add(const char* name, const std::vector<std::string>& values);
  /// Places as [[x, y, z], ...]; at most the first hundred.
  Report& Add(const char* name, const std::vector<Vec3>& places);
  Report& Add(const char* name, const std::vector<Report>& rows);
  /// The report in a line that a user understands, its "summary".
  Report& Tell(const std::string& line);
  const std::string& Line() const { return this->Told; }
  std::string Json() const { return "{" + this->Text + "}"; }

private:
  Report& Put(const char* name, const std::string& json);

  std::string Text;
  std::string Told;
};

/// Attach a stage's report to the field data of `output`: strings named "LaminaReport_" and the stage, the
/// JSON and the line.
void AttachReport(vtkDataObject* output, const char* stage, const Report& report);
/// The line of the report that the stage attached to one of its outputs; empty before it ran. It lives as
/// long as that output.
const char* SummaryOf(vtkAlgorithm* self, const char* stage);

} // namespace lamina
