// SPDX-License-Identifier: BSD-3-Clause
#include "EditText.h"

#include <vtk_nlohmannjson.h>
#include VTK_NLOHMANN_JSON(json.hpp)

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>

namespace lamina
{

namespace
{

using Json = nlohmann::json;

/// In a file; a later layout of it would count on.
constexpr const char* Format = "Lamina voxel edits";
constexpr int Version = 1;
/// Runs may not stand for more ids than any image has voxels: a slip of the pen must not fill the memory.
constexpr Id MostIds = 1LL << 32;

/// What is wrong with an edit, thrown inside this file only.
struct Wrong
{
  std::string message;
};

/// The library's message without its own numbering in front: "parse error at line 1, column 7: ...".
std::string Plain(const std::exception& error)
{
  const std::string text = error.what();
  const std::size_t end = text.find("] ");
  return text.rfind("[json.", 0) == 0 && end != std::string::npos ? text.substr(end + 2) : text;
}

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

void ReadVoxels(const Json& json, VoxelEdit& edit)
{
  CheckKeys(json, { "dimensions", "ids" });
  edit.shape = EditShape::Voxels;
  if (json.contains("dimensions"))
  {
    const Json& size = List(json, "dimensions", 3);
    for (std::size_t a = 0; a < 3; ++a)
    {
      edit.size[a] = Whole(size[a], "dimensions");
      if (edit.size[a] < 1)
      {
        throw Wrong{ "\"dimensions\" must be three numbers of voxels above 0" };
      }
    }
  }
  for (const Json& item : List(json, "ids", 0))
  {
    const bool run = item.is_array();
    if (run && item.size() != 2)
    {
      throw Wrong{ "\"ids\" must be made of ids and of runs [first, last], not " + item.dump() };
    }
    const Id first = Whole(run ? item[0] : item, "ids");
    const Id last = Whole(run ? item[1] : item, "ids");
    if (first > last)
    {
      throw Wrong{ "\"ids\" has the run " + item.dump() + ": give its first id first" };
    }
    if (first < 0 || last >= MostIds)
    {
      throw Wrong{ "\"ids\" has " + item.dump() + ", which is outside any image" };
    }
    if (static_cast<Id>(edit.voxels.size()) + (last - first) >= MostIds)
    {
      throw Wrong{ "\"ids\" has more ids than an image has voxels" };
    }
    for (Id id = first; id <= last; ++id)
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

Result<Json> Parse(const std::string& text, const std::string& what)
{
  try
  {
    return Json::parse(text);
  }
  catch (const Json::exception& error)
  {
    return InvalidOption(what + " is not JSON: " + Plain(error));
  }
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
  const Result<Json> json = Parse(text, name);
  return json ? Interpret(*json, name) : Result<VoxelEdit>(json.GetError());
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

Result<std::vector<std::string>> ReadEditFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  if (!file || !(content << file.rdbuf()))
  {
    return InvalidInput("the file of edits " + path +
                        " cannot be read: check its name and that it is not empty");
  }
  const Result<Json> json = Parse(content.str(), "the file " + path);
  if (!json)
  {
    return json.GetError();
  }
  if (!json->is_object() || json->value("format", Json()) != Format ||
      json->value("version", Json()) != Version || !json->value("edits", Json()).is_array())
  {
    return InvalidInput("the file " + path + " holds no edits: it must be an object with \"format\": \"" +
                        Format + "\", \"version\": " + std::to_string(Version) + " and a list \"edits\"");
  }
  std::vector<std::string> texts;
  for (const Json& edit : (*json)["edits"])
  {
    const Result<VoxelEdit> read =
      Interpret(edit, "the file " + path + ", edit " + std::to_string(texts.size() + 1));
    if (!read)
    {
      return read.GetError();
    }
    texts.push_back(edit.dump());
  }
  return texts;
}

Result<bool> WriteEditFile(const std::string& path, const std::vector<std::string>& edits)
{
  std::string text = std::string("{\n  \"format\": \"") + Format +
                     "\",\n  \"version\": " + std::to_string(Version) + ",\n  \"edits\": [";
  for (std::size_t e = 0; e < edits.size(); ++e)
  {
    const Result<VoxelEdit> edit = ParseEdit(edits[e], "edit " + std::to_string(e + 1));
    if (!edit)
    {
      return edit.GetError();
    }
    text += (e == 0 ? "\n    " : ",\n    ") + WriteEdit(*edit);
  }
  text += "\n  ]\n}\n";
  const std::string unfinished = path + ".part";
  {
    std::ofstream file(unfinished, std::ios::binary);
    file << text;
    file.close();
    if (!file)
    {
      std::remove(unfinished.c_str());
      return InvalidInput("the file of edits " + path +
                          " cannot be written: check its folder and the space left");
    }
  }
  if (std::rename(unfinished.c_str(), path.c_str()) != 0)
  {
    std::remove(unfinished.c_str());
    return InvalidInput("the file of edits " + path + " cannot be written: is it a folder, or not yours?");
  }
  return true;
}

} // namespace lamina
