// SPDX-License-Identifier: BSD-3-Clause
#include "MeshPatches.h"

#include "Adjacency.h"
#include "PieceOrder.h"
#include "RawFaces.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace lamina
{
namespace
{

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

/// The name that somebody gave to a plane patch of the surface: what is after its kind is more than a number.
/// Empty if nobody did.
std::string GivenName(const TriangleComplex* surface, int patch)
{
  const auto at = static_cast<std::size_t>(patch);
  if (surface == nullptr || patch == 0 || at >= surface->patchNames.size())
  {
    return "";
  }
  const std::string& name = surface->patchNames[at];
  const auto own = name.find('_');
  const bool isGiven = own != std::string::npos && own + 1 < name.size() &&
                       name.find_first_not_of("0123456789", own + 1) != std::string::npos;
  return isGiven ? name : "";
}

/// Gives materials and patches their names, and remembers what was asked for in vain.
class Naming
{
public:
  Naming(const std::map<std::string, std::string>& names, FindPatchesReport& report)
    : Names(names)
    , Report(report)
  {
  }
  /// The name to use instead of `own`.
  std::string Replace(const std::string& own)
  {
    const auto found = this->Names.find(own);
    if (found == this->Names.end())
    {
      return own;
    }
    this->Used.insert(own);
    return found->second;
  }
  std::string Name(const MeshPatch& patch, std::size_t number, const std::map<int, std::string>& materials)
  {
    const auto short_ = [&](int material)
    {
      const auto found = materials.find(material);
      return found == materials.end() ? std::to_string(material) : found->second;
    };
    const char* const kinds[] = { "interface", "wall", "border", "opening" };
    std::string name = std::string(kinds[static_cast<int>(patch.kind)]) + "_" + short_(patch.pair.first);
    if (patch.kind == PatchKind::Interface)
    {
      name += "_" + short_(patch.pair.second);
    }
    name = this->Replace(patch.name.empty() ? name + "_" + std::to_string(number) : patch.name);
    std::string unique = name;
    for (int n = 2; !this->Taken.insert(unique).second; ++n)
    {
      unique = name + "_" + std::to_string(n);
    }
    return unique;
  }
  void Close()
  {
    for (const auto& entry : this->Names)
    {
      if (this->Used.count(entry.first) == 0)
      {
        this->Report.unusedNames.push_back(entry.first);
      }
    }
  }

private:
  const std::map<std::string, std::string>& Names;
  FindPatchesReport& Report;
  std::set<std::string> Used;
  std::set<std::string> Taken;
};

/// The patches in their final order, named; `rank` gets each piece's place in it.
std::vector<MeshPatch> NamePatches(std::vector<MeshPatch> pieces, double extent,
                                   const std::map<int, std::string>& materials, Naming& naming,
                                   std::vector<int>& rank)
{
  std::map<std::tuple<PatchKind, int, int>, std::vector<std::size_t>> families;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    pieces[p].centre *= pieces[p].area > 0 ? 1 / pieces[p].area : 0;
    families[{ pieces[p].kind, pieces[p].pair.first, pieces[p].pair.second }].push_back(p);
  }
  std::vector<MeshPatch> patches;
  rank.assign(pieces.size(), 0);
  for (const auto& family : families)
  {
    std::vector<Piece> members;
    for (std::size_t p : family.second)
    {
      members.push_back({ pieces[p].area, pieces[p].centre });
    }
    std::size_t number = 0;
    for (std::size_t m : OrderPieces(members, extent))
    {
      const std::size_t p = family.second[m];
      rank[p] = static_cast<int>(patches.size());
      patches.push_back(pieces[p]);
      number += patches.back().name.empty() ? 1 : 0;
      patches.back().name = naming.Name(patches.back(), number, materials);
    }
  }
  return patches;
}

} // namespace

void AddToPatch(const VolumeMesh& mesh, const std::array<Id, 4>& corners, MeshPatch& patch)
{
  const auto at = [&](std::size_t k) { return mesh.points[Index(corners[k])]; };
  for (std::size_t k = 1; k < (corners[3] < 0 ? 2u : 3u); ++k)
  {
    const double area = 0.5 * Norm(Cross(at(k) - at(0), at(k + 1) - at(0)));
    patch.area += area;
    patch.centre += (at(0) + at(k) + at(k + 1)) * (area / 3);
  }
  ++patch.faces;
}

std::string MaterialName(const std::map<int, std::string>& names, int material)
{
  const auto found = names.find(material);
  return found == names.end() ? "material_" + std::to_string(material) : found->second;
}

Result<FindPatchesReport> FindPatches(const VolumeMesh& mesh, const TriangleComplex* surface,
                                      const FindPatchesOptions& options, MeshPatches& patches,
                                      Monitor& monitor, const CellFaces* known)
{
  if (!(options.surfaceScale > 0 && std::isfinite(options.surfaceScale)))
  {
    return InvalidOption("surfaceScale is " + std::to_string(options.surfaceScale) + ", but must be above 0");
  }
  monitor.Progress(0, "Finding the faces");
  const std::vector<RawFace> raw = CollectFaces(mesh, surface, options.surfaceScale, known, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  monitor.Progress(0.7, "Telling the patches apart");
  std::size_t count = 0;
  const std::vector<std::size_t> pieceOf = FindPieces(raw, count);
  std::vector<MeshPatch> pieces(count);
  for (std::size_t f = 0; f < raw.size(); ++f)
  {
    pieces[pieceOf[f]].kind = raw[f].group.kind;
    pieces[pieceOf[f]].pair = raw[f].group.pair;
    pieces[pieceOf[f]].name = GivenName(surface, raw[f].group.surfacePatch);
    AddToPatch(mesh, raw[f].corners, pieces[pieceOf[f]]);
  }
  FindPatchesReport report;
  Naming naming(options.names, report);
  MeshPatches found;
  for (int material : std::set<int>(mesh.materials.begin(), mesh.materials.end()))
  {
    const std::string own = std::to_string(material);
    const std::string name = naming.Replace(own);
    if (name != own)
    {
      found.materialNames[material] = name;
    }
  }
  std::vector<int> rank;
  found.patches = NamePatches(std::move(pieces), ExtentOf(mesh.points), found.materialNames, naming, rank);
  naming.Close();
  for (std::size_t f = 0; f < raw.size(); ++f)
  {
    found.faces.push_back(raw[f].face);
    found.faces.back().patch = rank[pieceOf[f]];
  }
  std::stable_sort(found.faces.begin(), found.faces.end(),
                   [](const PatchFace& a, const PatchFace& b) { return a.patch < b.patch; });
  report.patches = static_cast<Id>(found.patches.size());
  report.faces = static_cast<Id>(found.faces.size());
  patches = std::move(found);
  monitor.Progress(1, "Patches named");
  return report;
}

} // namespace lamina
