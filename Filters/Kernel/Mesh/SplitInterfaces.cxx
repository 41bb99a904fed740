// SPDX-License-Identifier: BSD-3-Clause
#include "SplitInterfaces.h"

#include <algorithm>

namespace lamina
{

Result<SplitInterfacesReport> SplitInterfaces(VolumeMesh& mesh, const std::vector<int>& fluids,
                                              std::vector<Id>& twinOf, Monitor& monitor)
{
  const auto isFluid = [&](std::size_t cell)
  { return std::find(fluids.begin(), fluids.end(), mesh.materials[cell]) != fluids.end(); };
  constexpr unsigned char inSolid = 1;
  constexpr unsigned char inFluid = 2;
  const std::size_t points = mesh.points.size();
  monitor.Progress(0, "Parting fluids and solids");
  std::vector<unsigned char> use(points, 0);
  for (std::size_t c = 0; c < mesh.types.size(); ++c)
  {
    const unsigned char bit = isFluid(c) ? inFluid : inSolid;
    for (Id i = mesh.offsets[c]; i < mesh.offsets[c + 1]; ++i)
    {
      use[static_cast<std::size_t>(mesh.connectivity[static_cast<std::size_t>(i)])] |= bit;
    }
  }
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  twinOf.assign(points, -1);
  for (std::size_t p = 0; p < points; ++p)
  {
    if (use[p] != (inSolid | inFluid))
    {
      continue;
    }
    twinOf[p] = static_cast<Id>(mesh.points.size());
    mesh.points.push_back(Vec3(mesh.points[p]));
    if (!mesh.layerIndex.empty())
    {
      mesh.layerIndex.push_back(int(mesh.layerIndex[p]));
    }
    if (!mesh.interfaceNodeIds.empty())
    {
      mesh.interfaceNodeIds.push_back(Id(mesh.interfaceNodeIds[p]));
    }
    twinOf.push_back(static_cast<Id>(p));
  }
  for (std::size_t c = 0; c < mesh.types.size(); ++c)
  {
    for (Id i = mesh.offsets[c]; isFluid(c) && i < mesh.offsets[c + 1]; ++i)
    {
      Id& node = mesh.connectivity[static_cast<std::size_t>(i)];
      const Id twin = twinOf[static_cast<std::size_t>(node)];
      node = twin >= 0 ? twin : node;
    }
  }
  monitor.Progress(1, "Fluids and solids parted");
  return SplitInterfacesReport{ static_cast<Id>(mesh.points.size() - points) };
}

} // namespace lamina
