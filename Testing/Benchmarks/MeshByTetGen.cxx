// SPDX-License-Identifier: BSD-3-Clause
// What TetGen alone makes of a surface, for ComparePeers.py: MeshByTetGen FILE OUTPUT
//
// FILE: counts of points and triangles, points, triangles, and the two materials of each triangle. TetGen gets the
// switches that Core Tetrahedra gives it; nothing is improved afterwards.
#include "PeerFiles.h"
#include "RefinementFiles.h"
#include "Volume/CoreTetsFill.h"

#include <cstdio>

using namespace lamina;

int main(int argc, char** argv)
{
  if (argc < 3)
  {
    std::printf("MeshByTetGen FILE OUTPUT\n");
    return 1;
  }
  std::ifstream file(argv[1], std::ios::binary);
  TriangleComplex surface;
  const auto counts = Take<Id>(file, 2);
  surface.points = Take<Vec3>(file, static_cast<std::size_t>(counts[0]));
  surface.triangles = Take<Triangle>(file, static_cast<std::size_t>(counts[1]));
  surface.materials = Take<MaterialPair>(file, surface.triangles.size());
  ThreadMonitor monitor(1);
  CoreTetsReport report;
  const auto filled = FillCore(surface, {}, {}, {}, report, monitor);
  if (!filled)
  {
    std::printf("%s\n", filled.GetError().message.c_str());
    return 1;
  }
  std::printf("%zu tets, rung %d\n", filled->tets.size(), report.rung);
  return WritePeerMesh(argv[2], filled->points, filled->tets, filled->groups) ? 0 : 1;
}
