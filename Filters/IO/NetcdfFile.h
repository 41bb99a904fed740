// SPDX-License-Identifier: BSD-3-Clause
// A netCDF file in the classic format with 64-bit offsets, without records: all that Exodus needs.
#pragma once

#include "TextFile.h"

#include <functional>
#include <vector>

namespace lamina
{

/// Define dimensions, attributes and variables, then Write: the header, then the variables one after the
/// other in the order of their definition. Source of the layout: NetCDF Classic Format Specification.
class NetcdfFile
{
public:
  enum Type : int
  {
    Char = 2,
    Int = 4,
    Float = 5,
    Double = 6
  };
  /// Gives value number i of a variable.
  using Values = std::function<double(Id i)>;

  /// A dimension; of no length it is unlimited, and has no variables here.
  int AddDimension(const std::string& name, Id length);
  void AddText(const std::string& name, const std::string& value);
  void AddNumber(const std::string& name, Type type, double value);
  /// A variable over dimensions; Chars by `text`, numbers by `values`. `note` becomes its attribute
  /// `noteName`.
  void AddVariable(const std::string& name, const std::vector<int>& dimensions, Type type, Values values,
                   const std::string& noteName = "", const std::string& note = "");
  /// Rows of text, filled up with zeros.
  void AddStrings(const std::string& name, int count, int length, const std::vector<std::string>& rows);

  Status Write(const std::string& path) const;

private:
  struct Dimension
  {
    std::string name;
    Id length;
  };
  struct Attribute
  {
    std::string name;
    Type type;
    std::string text;
    double number;
  };
  struct Variable
  {
    std::string name;
    std::vector<int> dimensions;
    Type type;
    Values values;
    std::vector<Attribute> attributes;
  };

  Id Length(const Variable& variable) const;
  Id PaddedBytes(const Variable& variable) const;
  std::string Header(Id headerBytes) const;
  static void PutAttributes(std::string& out, const std::vector<Attribute>& attributes);

  std::vector<Dimension> Dimensions;
  std::vector<Attribute> Attributes;
  std::vector<Variable> Variables;
};

} // namespace lamina
