// SPDX-License-Identifier: BSD-3-Clause
#include "EditFile.h"

#include "EditText.h"

#include "Json.h"

#include <cstdio>
#include <fstream>
#include <sstream>

namespace lamina
{

namespace
{

/// The head of a file; a later layout would count on.
constexpr const char* Format = "Lamina voxel edits";
constexpr int Version = 1;

} // namespace

Result<std::vector<std::string>> ReadEditFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  if (!file || !(content << file.rdbuf()))
  {
    return InvalidInput("the file of edits " + path +
                        " cannot be read: check its name and that it is not empty");
  }
  Json json;
  try
  {
    json = Json::parse(content.str());
  }
  catch (const Json::exception& error)
  {
    return InvalidInput("the file of edits " + path + " is not JSON: " + PlainMessage(error));
  }
  if (!json.is_object() || json.value("format", Json()) != Format ||
      json.value("version", Json()) != Version || !json.value("edits", Json()).is_array())
  {
    return InvalidInput("the file " + path + " holds no edits: it must be an object with \"format\": \"" +
                        Format + "\", \"version\": " + std::to_string(Version) + " and a list \"edits\"");
  }
  std::vector<std::string> texts;
  for (const Json& edit : json["edits"])
  {
    const Result<VoxelEdit> read =
      ParseEdit(edit.dump(), "the file of edits " + path + ", edit " + std::to_string(texts.size() + 1));
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
