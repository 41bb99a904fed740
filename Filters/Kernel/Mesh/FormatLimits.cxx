// SPDX-License-Identifier: BSD-3-Clause
#include "FormatLimits.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <set>

namespace lamina
{
namespace
{

/// Eight hexadecimal digits of a name (FNV-1a), the same on every machine.
std::string Digest(const std::string& name)
{
  std::uint32_t hash = 2166136261u;
  for (char c : name)
  {
    hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  }
  char text[12];
  std::snprintf(text, sizeof text, "%08x", static_cast<unsigned>(hash));
  return text;
}

std::string Cleaned(const FormatLimits& limits, const std::string& name)
{
  std::string clean;
  for (char c : name)
  {
    const auto u = static_cast<unsigned char>(c);
    const bool isPlain = u < 128 && (std::isalnum(u) != 0 || c == '_');
    const bool isKept = limits.lettersOnly ? isPlain : u >= 32 && c != '"';
    clean += isKept ? c : '_';
  }
  if (limits.lettersOnly && (clean.empty() || std::isalpha(static_cast<unsigned char>(clean[0])) == 0))
  {
    clean = "n_" + clean;
  }
  return clean;
}

std::string Shortened(const std::string& clean, const std::string& name, std::size_t most)
{
  const std::string digest = Digest(name);
  const std::size_t tail = std::min(digest.size() + 1, most);
  return clean.substr(0, most - tail) + ("_" + digest).substr(0, tail);
}

} // namespace

FormatLimits LimitsOf(const std::string& format, Id largestId, std::size_t nameLength)
{
  FormatLimits limits;
  limits.format = format;
  limits.largestId = largestId;
  limits.nameLength = nameLength;
  return limits;
}

FormatLimits TetrahedraOnly(const std::string& format, Id largestId, std::size_t nameLength)
{
  FormatLimits limits = LimitsOf(format, largestId, nameLength);
  limits.holdsWedges = false;
  limits.holdsPyramids = false;
  return limits;
}

Result<bool> CheckCount(const FormatLimits& limits, Id count, const char* what)
{
  if (limits.largestId > 0 && count > limits.largestId)
  {
    return Unreachable("the mesh has " + std::to_string(count) + " " + what + ", but " + limits.format +
                       " can number " + std::to_string(limits.largestId) +
                       ": mesh with a larger size, or choose another format such as Exodus or VTU");
  }
  return true;
}

Result<bool> CheckFormat(const FormatLimits& limits, const MeshModel& model)
{
  const auto count = [&](CellType type)
  { return std::count(model.mesh.types.begin(), model.mesh.types.end(), type); };
  const Id wedges = limits.holdsWedges ? 0 : count(CellType::Wedge);
  const Id pyramids = limits.holdsPyramids ? 0 : count(CellType::Pyramid);
  if (wedges + pyramids > 0)
  {
    return Unreachable(
      limits.format + " cannot hold the mesh's " + (wedges > 0 ? std::to_string(wedges) + " prisms" : "") +
      (wedges > 0 && pyramids > 0 ? " and " : "") +
      (pyramids > 0 ? std::to_string(pyramids) + " pyramids" : "") + ": run Prisms to Tetrahedra first");
  }
  if (model.IsQuadratic() && !limits.holdsQuadratic)
  {
    return Unreachable(limits.format +
                       " is written with linear cells only: save the mesh from before Quadratic Cells");
  }
  if (model.IsQuadratic() && !limits.holdsQuadraticPyramids && count(CellType::Pyramid) > 0)
  {
    return Unreachable(limits.format + " cannot hold quadratic pyramids: run Prisms to Tetrahedra before "
                                       "Quadratic Cells");
  }
  const auto points = CheckCount(limits, static_cast<Id>(model.mesh.points.size()), "nodes");
  if (!points)
  {
    return points;
  }
  return CheckCount(limits, model.mesh.CellCount() + static_cast<Id>(model.patches.faces.size()),
                    "cells and faces of patches");
}

std::vector<std::string> FitNames(const FormatLimits& limits, const std::vector<std::string>& names,
                                  std::vector<std::string>& notes)
{
  const auto folded = [&](std::string name)
  {
    if (limits.ignoresCase)
    {
      std::transform(name.begin(), name.end(), name.begin(),
                     [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    }
    return name;
  };
  std::set<std::string> taken;
  std::vector<std::string> fitted;
  for (const std::string& name : names)
  {
    std::string fit = Cleaned(limits, name);
    const std::size_t most = limits.nameLength > 0 ? limits.nameLength : fit.size() + 9;
    if (fit.size() > most || taken.count(folded(fit)) != 0)
    {
      fit = Shortened(fit, name, most);
    }
    for (int n = 2; taken.count(folded(fit)) != 0; ++n)
    {
      fit = Shortened(fit, name + "#" + std::to_string(n), most);
    }
    taken.insert(folded(fit));
    if (fit != name)
    {
      notes.push_back("\"" + name + "\" is written as \"" + fit + "\", as " + limits.format + " takes " +
                      (limits.nameLength > 0 ? std::to_string(limits.nameLength) + " characters" : "names") +
                      (limits.lettersOnly ? " of letters, digits and _" : ""));
    }
    fitted.push_back(fit);
  }
  return fitted;
}

} // namespace lamina
