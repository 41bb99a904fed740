// SPDX-License-Identifier: BSD-3-Clause
#include "NameList.h"

#include <set>
#include <sstream>

namespace lamina
{
namespace
{

std::string Trimmed(const std::string& text)
{
  const auto begin = text.find_first_not_of(" \t\r\n");
  const auto end = text.find_last_not_of(" \t\r\n");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

} // namespace

Result<std::map<std::string, std::string>> ParseNames(const std::string& text)
{
  std::map<std::string, std::string> names;
  std::set<std::string> given;
  std::istringstream stream(text);
  for (std::string entry; std::getline(stream, entry, ';');)
  {
    if (Trimmed(entry).empty())
    {
      continue;
    }
    const auto equals = entry.find('=');
    const std::string own = equals == std::string::npos ? "" : Trimmed(entry.substr(0, equals));
    const std::string name = equals == std::string::npos ? "" : Trimmed(entry.substr(equals + 1));
    if (own.empty() || name.empty())
    {
      return InvalidOption("Names: '" + Trimmed(entry) +
                           "' is not understood; write such as 1=tissue; wall_tissue_1=epicardium");
    }
    if (!names.emplace(own, name).second)
    {
      return InvalidOption("Names: " + own + " is named twice");
    }
    if (!given.insert(name).second)
    {
      return InvalidOption("Names: the name " + name + " is given twice");
    }
  }
  return names;
}

std::vector<std::string> SplitNames(const std::string& text)
{
  std::vector<std::string> names;
  std::istringstream stream(text);
  for (std::string name; std::getline(stream, name, ';');)
  {
    if (!Trimmed(name).empty())
    {
      names.push_back(Trimmed(name));
    }
  }
  return names;
}

} // namespace lamina
