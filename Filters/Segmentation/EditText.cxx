// SPDX-License-Identifier: BSD-3-Clause
#include "EditText.h"

#include "Json.h"

#include <algorithm>
#include <limits>

namespace lamina
{

namespace
{

/// Runs of an edit that does not say its image's size: a slip of the pen must not fill the memory.
constexpr double MostIds = 1 << 28;

/// What is wrong with an edit, thrown inside this file only.
struct Wrong
{
  std::string message;
};

const Json& Member(const Json& edit, const char* key)
{
  const auto found = edit.find(key);
  if (found == edit.end())
  {
    throw Wrong{ std::string("\"") + key + "\" is missing" };
  }
  return *found;
}

double Number(const Json& value, const std::string& key)
{
  if (!value.is_number())
  {
    throw Wrong{ "\"" + key + "\" must be made of numbers, not " + value.dump() };
  }
  return value.get<double>();
}

Id Whole(const Json& value, const std::string& key)
{
  const bool huge =
    value.is_number_unsigned() &&
    value.get<unsigned long long>() > static_cast<unsigned long long>(std::numeric_limits<Id>::max());
  if (!value.is_number_integer() || huge)
  {
    throw Wrong{ "\"" + key + "\" must be made of whole numbers, not " + value.dump() };
  }
  return value.get<Id>();
}

int Material(const Json& value, const std::string& key)
{
  const Id id = Whole(value, key);
  if (id < 0 || id > 65535)
  {
    throw Wrong{ "\"" + key + "\" names material " + std::to_string(id) +
                 ", material ids run from 0 to 65535" };
  }
  return static_cast<int>(id);
}

const Json& List(const Json& edit, const char* key, std::size_t length)
{
  const Json& value = Member(edit, key);
  if (!value.is_array() || (length > 0 && value.size() != length))
  {
    throw Wrong{ std::string("\"") + key + "\" must be a list" +
                 (length > 0 ? " of " + std::to_string(length) + " numbers" : "") };
  }
  return value;
}

/// A misspelt restriction must not go unnoticed.
void CheckKeys(const Json& edit, const std::vector<std::string>& own)
{
  for (const auto& item : edit.items())
  {
    const std::string& key = item.key();
    if (key != "shape" && key != "from" && key != "to" && std::find(own.begin(), own.end(), key) == own.end())
    {
      std::string known = "shape, from, to";
      for (const std::string& name : own)
      {
        known += ", " + name;
      }
      throw Wrong{ "\"" + key + "\" is not known; this shape has " + known };
    }
  }
}

void ReadBox(const Json& json, VoxelEdit& edit)
{
  CheckKeys(json, { "bounds" });
  edit.shape = EditShape::Box;
  const Json& bounds = List(json, "bounds", 6);
  for (int a = 0; a < 3; ++a)
  {
    edit.low[a] = Number(bounds[static_cast<std::size_t>(2 * a)], "bounds");
    edit.high[a] = Number(bounds[static_cast<std::size_t>(2 * a + 1)], "bounds");
  }
}

void ReadSphere(const Json& json, VoxelEdit& edit)
{
  CheckKeys(json, { "center", "radius" });
  edit.shape = EditShape::Sphere;
  const Json& centre = List(json, "center", 3);
  for (int a = 0; a < 3; ++a)
  {
    edit.centre[a] = Number(centre[static_cast<std::size_t>(a)], "center");
  }
  edit.radius = Number(Member(json, "radius"), "radius");
}

/// The number of voxels that "dimensions" make.
double ReadSize(const Json& size, VoxelEdit& edit)
{
  double voxels = 1;
  for (std::size_t a = 0; a < 3; ++a)
  {
    edit.size[a] = Whole(size[a], "dimensions");
    if (edit.size[a] < 1 || edit.size[a] > std::numeric_limits<int>::max())
    {
      throw Wrong{ "\"dimensions\" must be three numbers of voxels above 0, not " + size.dump() };
    }
    voxels *= static_cast<double>(edit.size[a]);
  }
  return voxels;
}

std::pair<Id, Id> ReadRun(const Json& item)
{
  const bool run = item.is_array();
  if (run && item.size() != 2)
  {
    throw Wrong{ "\"ids\" must be made of ids and of runs [first, last], not " + item.dump() };
  }
  const std::pair<Id, Id> ends{ Whole(run ? item[0] : item, "ids"), Whole(run ? item[1] : item, "ids") };
  if (ends.first > ends.second)
  {
    throw Wrong{ "\"ids\" has the run " + item.dump() + ": give its first id first" };
  }
  return ends;
}

void ReadVoxels(const Json& json, VoxelEdit& edit)
{
  CheckKeys(json, { "dimensions", "ids" });
  edit.shape = EditShape::Voxels;
  double most = MostIds;
  if (json.contains("dimensions"))
  {
    most = ReadSize(List(json, "dimensions", 3), edit);
  }
  double ids = 0;
  for (const Json& item : List(json, "ids", 0))
  {
    const auto run = ReadRun(item);
    ids += static_cast<double>(run.second) - static_cast<double>(run.first) + 1;
    if (ids > most)
    {
      throw Wrong{ "\"ids\" has more ids than " + std::to_string(static_cast<Id>(most)) +
                   ", the voxels of its image" };
    }
    for (Id id = run.first; id <= run.second; ++id)
    {
      edit.voxels.push_back(id);
    }
  }
}

VoxelEdit Read(const Json& json)
{
  if (!json.is_object())
  {
    throw Wrong{
      "an edit is an object such as {\"shape\": \"box\", \"bounds\": [0, 1, 0, 1, 0, 1], \"to\": 2}"
    };
  }
  VoxelEdit edit;
  const Json& shape = Member(json, "shape");
  if (shape == "box")
  {
    ReadBox(json, edit);
  }
  else if (shape == "sphere")
  {
    ReadSphere(json, edit);
  }
  else if (shape == "voxels")
  {
    ReadVoxels(json, edit);
  }
  else
  {
    throw Wrong{ "the shape " + shape.dump() + " is not known; there are box, sphere and voxels" };
  }
  edit.to = Material(Member(json, "to"), "to");
  if (json.contains("from"))
  {
    for (const Json& id : List(json, "from", 0))
    {
      edit.from.push_back(Material(id, "from"));
    }
  }
  return edit;
}

Json Runs(std::vector<Id> ids)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  Json runs = Json::array();
  for (std::size_t i = 0; i < ids.size();)
  {
    std::size_t end = i + 1;
    while (end < ids.size() && ids[end] == ids[end - 1] + 1)
    {
      ++end;
    }
    if (end - i > 1)
    {
      runs.push_back(Json::array({ ids[i], ids[end - 1] }));
    }
    else
    {
      runs.push_back(ids[i]);
    }
    i = end;
  }
  return runs;
}

Result<VoxelEdit> Interpret(const Json& json, const std::string& name)
{
  try
  {
    VoxelEdit edit = Read(json);
    edit.name = name;
    return edit;
  }
  catch (const Wrong& wrong)
  {
    return InvalidOption(name + ": " + wrong.message);
  }
}

} // namespace

Result<VoxelEdit> ParseEdit(const std::string& text, const std::string& name)
{
  try
  {
    return Interpret(Json::parse(text), name);
  }
  catch (const Json::exception& error)
  {
    return InvalidOption(name + " is not JSON: " + PlainMessage(error));
  }
}

std::string PlainMessage(const std::exception& error)
{
  const std::string text = error.what();
  const std::size_t end = text.find("] ");
  return text.rfind("[json.", 0) == 0 && end != std::string::npos ? text.substr(end + 2) : text;
}

std::string WriteEdit(const VoxelEdit& edit)
{
  Json json{ { "shape", ShapeName(edit.shape) }, { "to", edit.to } };
  if (!edit.from.empty())
  {
    json["from"] = edit.from;
  }
  if (edit.shape == EditShape::Box)
  {
    json["bounds"] = { edit.low.x, edit.high.x, edit.low.y, edit.high.y, edit.low.z, edit.high.z };
  }
  else if (edit.shape == EditShape::Sphere)
  {
    json["center"] = { edit.centre.x, edit.centre.y, edit.centre.z };
    json["radius"] = edit.radius;
  }
  else
  {
    if (edit.size[0] > 0)
    {
      json["dimensions"] = edit.size;
    }
    json["ids"] = Runs(edit.voxels);
  }
  return json.dump();
}

} // namespace lamina
