// SPDX-License-Identifier: BSD-3-Clause
#include "NetcdfFile.h"

#include <cstdint>
#include <cstring>

namespace lamina
{
namespace
{

/// Numbers stand with their highest byte first.
template<typename T>
void PutBytes(std::string& out, T value)
{
  char bytes[sizeof(T)];
  for (std::size_t k = 0; k < sizeof(T); ++k)
  {
    bytes[k] = static_cast<char>(static_cast<std::uint64_t>(value) >> 8 * (sizeof(T) - 1 - k) & 0xff);
  }
  out.append(bytes, sizeof(T));
}

void PutInt(std::string& out, Id value)
{
  PutBytes(out, static_cast<std::uint32_t>(value));
}

void Fill(std::string& out)
{
  out.append((4 - out.size() % 4) % 4, '\0');
}

void PutName(std::string& out, const std::string& name)
{
  PutInt(out, static_cast<Id>(name.size()));
  out += name;
  Fill(out);
}

void PutValue(std::string& out, NetcdfFile::Type type, double value)
{
  if (type == NetcdfFile::Char)
  {
    out += static_cast<char>(value);
  }
  else if (type == NetcdfFile::Int)
  {
    PutInt(out, static_cast<Id>(value));
  }
  else if (type == NetcdfFile::Float)
  {
    const auto single = static_cast<float>(value);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &single, sizeof bits);
    PutBytes(out, bits);
  }
  else
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    PutBytes(out, bits);
  }
}

Id Width(NetcdfFile::Type type)
{
  return type == NetcdfFile::Char ? 1 : (type == NetcdfFile::Double ? 8 : 4);
}

constexpr Id DimensionTag = 10;
constexpr Id VariableTag = 11;
constexpr Id AttributeTag = 12;

/// A list's tag and length; an empty one has zeros for both.
void PutList(std::string& out, Id tag, std::size_t count)
{
  PutInt(out, count == 0 ? 0 : tag);
  PutInt(out, static_cast<Id>(count));
}

} // namespace

int NetcdfFile::AddDimension(const std::string& name, Id length)
{
  this->Dimensions.push_back({ name, length });
  return static_cast<int>(this->Dimensions.size()) - 1;
}

void NetcdfFile::AddText(const std::string& name, const std::string& value)
{
  this->Attributes.push_back({ name, Char, value, 0 });
}

void NetcdfFile::AddNumber(const std::string& name, Type type, double value)
{
  this->Attributes.push_back({ name, type, "", value });
}

void NetcdfFile::AddVariable(const std::string& name, const std::vector<int>& dimensions, Type type,
                             Values values, const std::string& noteName, const std::string& note)
{
  this->Variables.push_back({ name, dimensions, type, std::move(values), {} });
  if (!noteName.empty())
  {
    this->Variables.back().attributes.push_back({ noteName, Char, note, 0 });
  }
}

void NetcdfFile::AddStrings(const std::string& name, int count, int length,
                            const std::vector<std::string>& rows)
{
  const Id width = this->Dimensions[static_cast<std::size_t>(length)].length;
  this->AddVariable(name, { count, length }, Char,
                    [rows, width](Id i)
                    {
                      const std::string& row = rows[static_cast<std::size_t>(i / width)];
                      const auto at = static_cast<std::size_t>(i % width);
                      return at < row.size() ? static_cast<double>(row[at]) : 0.0;
                    });
}

Id NetcdfFile::Length(const Variable& variable) const
{
  Id length = 1;
  for (int dimension : variable.dimensions)
  {
    length *= this->Dimensions[static_cast<std::size_t>(dimension)].length;
  }
  return length;
}

Id NetcdfFile::PaddedBytes(const Variable& variable) const
{
  return (this->Length(variable) * Width(variable.type) + 3) / 4 * 4;
}

void NetcdfFile::PutAttributes(std::string& out, const std::vector<Attribute>& attributes)
{
  PutList(out, AttributeTag, attributes.size());
  for (const Attribute& attribute : attributes)
  {
    PutName(out, attribute.name);
    PutInt(out, attribute.type);
    if (attribute.type == Char)
    {
      PutName(out, attribute.text); // length, text, padding: as of a name
    }
    else
    {
      PutInt(out, 1);
      PutValue(out, attribute.type, attribute.number);
    }
  }
}

std::string NetcdfFile::Header(Id headerBytes) const
{
  std::string out = "CDF\x02";
  PutInt(out, 0); // no records
  PutList(out, DimensionTag, this->Dimensions.size());
  for (const Dimension& dimension : this->Dimensions)
  {
    PutName(out, dimension.name);
    PutInt(out, dimension.length);
  }
  PutAttributes(out, this->Attributes);
  PutList(out, VariableTag, this->Variables.size());
  Id begin = headerBytes;
  for (const Variable& variable : this->Variables)
  {
    PutName(out, variable.name);
    PutInt(out, static_cast<Id>(variable.dimensions.size()));
    for (int dimension : variable.dimensions)
    {
      PutInt(out, dimension);
    }
    PutAttributes(out, variable.attributes);
    PutInt(out, variable.type);
    const Id bytes = this->PaddedBytes(variable);
    PutInt(out, std::min<Id>(bytes, 0xffffffff)); // redundant where it is too large for its field
    PutBytes(out, static_cast<std::uint64_t>(begin));
    begin += bytes;
  }
  return out;
}

Status NetcdfFile::Write(const std::string& path) const
{
  TextFile file(path);
  file << this->Header(static_cast<Id>(this->Header(0).size()));
  std::string bytes;
  for (const Variable& variable : this->Variables)
  {
    const Id length = this->Length(variable);
    for (Id i = 0; i < length; ++i)
    {
      PutValue(bytes, variable.type, variable.values(i));
      if (bytes.size() >= 65536)
      {
        file << bytes;
        bytes.clear();
      }
    }
    Fill(bytes); // pieces that were written are multiples of four
    file << bytes;
    bytes.clear();
  }
  return file.Close();
}

} // namespace lamina
