// SPDX-License-Identifier: BSD-3-Clause
#include "AssembleMesh.h"

#include "../Mesh/PointTable.h"

#include <algorithm>
#include <optional>

namespace lamina
{
namespace
{

constexpr std::size_t AskEvery = 1 << 16; ///< nodes or cells, whether to stop

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

/// Lengths and ranges of one part.
std::optional<Error> CheckPart(const VolumeMesh& part, std::size_t number)
{
  const std::string name = "part " + std::to_string(number) + " of the mesh";
  const std::size_t cells = part.types.size();
  const std::size_t points = part.points.size();
  const auto fits = [](std::size_t size, std::size_t wanted) { return size == 0 || size == wanted; };
  if (part.offsets.size() != cells + 1 || part.offsets.front() != 0 ||
      part.offsets.back() != static_cast<Id>(part.connectivity.size()) || part.materials.size() != cells ||
      !fits(part.layers.size(), cells) || !fits(part.layerIndex.size(), points) ||
      !fits(part.interfaceNodeIds.size(), points))
  {
    return InvalidInput(name + " has arrays whose lengths do not agree with its points and cells");
  }
  for (std::size_t c = 0; c < cells; ++c)
  {
    if (part.offsets[c + 1] - part.offsets[c] != NodeCount(part.types[c]))
    {
      return InvalidInput(name + ": cell " + std::to_string(c) + " has a wrong number of nodes");
    }
  }
  for (Id p : part.connectivity)
  {
    if (p < 0 || p >= static_cast<Id>(points))
    {
      return InvalidInput(name + " names a point that is not there");
    }
  }
  const auto bad = std::find_if_not(part.points.begin(), part.points.end(), IsFinite);
  if (bad != part.points.end())
  {
    return InvalidInput(name + ": point " + std::to_string(bad - part.points.begin()) +
                        " is not a finite position");
  }
  return std::nullopt;
}

/// Grows the joined mesh part by part.
class Joiner
{
public:
  Joiner(VolumeMesh& mesh, std::size_t points)
    : Mesh(mesh)
    , Table(points)
  {
  }

  /// Stops half way when cancelled.
  void Add(const VolumeMesh& part, Monitor& monitor)
  {
    ++this->Parts;
    std::vector<Id> joined(part.points.size(), -1);
    for (std::size_t i = 0; i < part.connectivity.size(); ++i)
    {
      if (i % AskEvery == 0 && monitor.Cancelled())
      {
        return;
      }
      const Id p = part.connectivity[i];
      if (joined[Index(p)] < 0)
      {
        joined[Index(p)] = this->AddPoint(part, Index(p));
      }
    }
    for (std::size_t c = 0; c < part.types.size(); ++c)
    {
      if (c % AskEvery == 0 && monitor.Cancelled())
      {
        return;
      }
      for (Id i = part.offsets[c]; i < part.offsets[c + 1]; ++i)
      {
        this->Mesh.connectivity.push_back(joined[Index(part.connectivity[Index(i)])]);
      }
      this->Mesh.offsets.push_back(static_cast<Id>(this->Mesh.connectivity.size()));
      this->Mesh.layers.push_back(part.layers.empty() ? 0 : part.layers[c]);
    }
    this->Mesh.types.insert(this->Mesh.types.end(), part.types.begin(), part.types.end());
    this->Mesh.materials.insert(this->Mesh.materials.end(), part.materials.begin(), part.materials.end());
  }

  Id CountMerged() const { return std::count(this->PartsOfPoint.begin(), this->PartsOfPoint.end(), -1); }
  std::vector<Vec3> TakePoints() { return this->Table.GetPoints(); }

private:
  Id AddPoint(const VolumeMesh& part, std::size_t p)
  {
    const int layer = part.layerIndex.empty() ? -1 : part.layerIndex[p];
    const Id node = part.interfaceNodeIds.empty() ? -1 : part.interfaceNodeIds[p];
    const Id id = this->Table.Insert(part.points[p]);
    if (Index(id) == this->PartsOfPoint.size())
    {
      this->PartsOfPoint.push_back(this->Parts);
      this->Mesh.layerIndex.push_back(layer);
      this->Mesh.interfaceNodeIds.push_back(node);
      return id;
    }
    int& home = this->PartsOfPoint[Index(id)];
    home = home == this->Parts ? home : -1;
    int& known = this->Mesh.layerIndex[Index(id)];
    known = known < 0 || layer < 0 ? std::max(known, layer) : std::min(known, layer);
    this->Mesh.interfaceNodeIds[Index(id)] = std::max(this->Mesh.interfaceNodeIds[Index(id)], node);
    return id;
  }

  VolumeMesh& Mesh;
  PointTable Table;
  std::vector<int> PartsOfPoint; ///< the one part a point is in, -1 for several
  int Parts = 0;
};

} // namespace

Result<AssembleMeshReport> AssembleMesh(const std::vector<const VolumeMesh*>& parts,
                                        const AssembleMeshOptions& options, VolumeMesh& mesh,
                                        Monitor& monitor)
{
  if (!(options.scale > 0 && std::isfinite(options.scale)))
  {
    return InvalidOption("scale is " + std::to_string(options.scale) + ", but must be above 0");
  }
  std::size_t points = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if (parts[i] == nullptr)
    {
      return InvalidInput("part " + std::to_string(i) + " of the mesh is missing");
    }
    if (auto error = CheckPart(*parts[i], i))
    {
      return *error;
    }
    points += parts[i]->points.size();
  }
  VolumeMesh joined;
  Joiner joiner(joined, points);
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    monitor.Progress(static_cast<double>(i) / static_cast<double>(parts.size()), "Joining the parts");
    if (monitor.Cancelled())
    {
      return Cancelled();
    }
    joiner.Add(*parts[i], monitor);
  }
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  joined.points = joiner.TakePoints();
  for (Vec3& p : joined.points)
  {
    p *= options.scale;
  }
  mesh = std::move(joined);
  AssembleMeshReport report;
  report.points = static_cast<Id>(mesh.points.size());
  report.cells = mesh.CellCount();
  report.mergedPoints = joiner.CountMerged();
  monitor.Progress(1, "Mesh joined");
  return report;
}

} // namespace lamina
