// SPDX-License-Identifier: BSD-3-Clause
// Refinement beside CGAL's isotropic remeshing, on one closed material to the same mean edge:
// CompareRemeshing FILE [NAME=VALUE]...
//
// FILE: .surface, as WriteRefinementInputs.py makes them. NAME: length (of the edges; 1.2 mean edges of the
// input without it), threads (of the refinement; CGAL uses one).
#include "Arguments.h"
#include "RefinementFiles.h"
#include "RefinementMeasures.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <chrono>
#include <ctime>

using namespace lamina;

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// Wall clock and processor time since its birth.
class Stopwatch
{
public:
  struct Time
  {
    double wall = 0;
    double processors = 0;
  };
  Time Read() const
  {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - this->Start;
    return { wall.count(), static_cast<double>(std::clock() - this->Used) / CLOCKS_PER_SEC };
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
  std::clock_t Used = std::clock();
};

CgalMesh ToCgal(const TriangleComplex& surface)
{
  CgalMesh mesh;
  std::vector<CgalMesh::Vertex_index> ids;
  for (const Vec3& p : surface.points)
  {
    ids.push_back(mesh.add_vertex({ p.x, p.y, p.z }));
  }
  const auto id = [&](Id p) { return ids[static_cast<std::size_t>(p)]; };
  for (const Triangle& t : surface.triangles)
  {
    mesh.add_face(id(t[0]), id(t[1]), id(t[2]));
  }
  return mesh;
}

TriangleComplex FromCgal(CgalMesh& mesh)
{
  mesh.collect_garbage();
  TriangleComplex surface;
  for (const auto v : mesh.vertices())
  {
    const Kernel::Point_3& p = mesh.point(v);
    surface.points.push_back({ p.x(), p.y(), p.z() });
  }
  for (const auto f : mesh.faces())
  {
    Triangle t;
    std::size_t k = 0;
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
    {
      t[k++] = static_cast<Id>(v.idx());
    }
    surface.triangles.push_back(t);
  }
  surface.materials.assign(surface.triangles.size(), { 1, 0 });
  return surface;
}

TriangleComplex RemeshWithCgal(const TriangleComplex& surface, double length, Stopwatch::Time& used)
{
  namespace pmp = CGAL::Polygon_mesh_processing;
  CgalMesh mesh = ToCgal(surface);
  const Stopwatch watch;
  pmp::isotropic_remeshing(faces(mesh), length, mesh,
                           CGAL::parameters::number_of_iterations(6).number_of_relaxation_steps(3));
  used = watch.Read();
  return FromCgal(mesh);
}

void Print(const char* name, const TriangleComplex& before, const TriangleComplex& after,
           const Stopwatch::Time& used, Monitor& monitor)
{
  const auto one = [](Id, const std::array<double, 3>&) { return 1.0; };
  const double mean = MeanEdgeLength(before);
  const double out = measures::FindFarthest(after, before, true, one, monitor).distance;
  const double back = measures::FindFarthest(before, after, false, one, monitor).distance;
  Id good = 0;
  double least = 1;
  for (const Triangle& t : after.triangles)
  {
    const double q =
      TriangleQuality(measures::At(after, t[0]), measures::At(after, t[1]), measures::At(after, t[2]));
    good += q >= 0.4 ? 1 : 0;
    least = std::min(least, q);
  }
  const auto count = static_cast<double>(after.triangles.size());
  const double volume = MaterialVolumes(after, { 1 })[0] / MaterialVolumes(before, { 1 })[0] - 1;
  std::printf("%-7s %.1f s (%.1f s of processors), %zu triangles, mean edge %.4f, quality %.4f %% >= 0.4, "
              "least %.3f; distance out "
              "%.3f, back %.3f mean edges of the input; volume %+.1e; %zu intersections\n",
              name, used.wall, used.processors, after.triangles.size(), MeanEdgeLength(after),
              100 * static_cast<double>(good) / count, least, out / mean, back / mean, volume,
              FindIntersections(after.points, after.triangles, monitor).size());
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 2)
  {
    std::printf("CompareRemeshing FILE.surface [length=L] [threads=N]\n");
    return 1;
  }
  const Arguments arguments(argc, argv);
  ThreadMonitor monitor(static_cast<int>(arguments.Get("threads", 2)));
  std::ifstream file(argv[1], std::ios::binary);
  const TriangleComplex input = FromTriangles(file);
  const double length = arguments.Get("length", 1.2 * MeanEdgeLength(input));
  TriangleComplex refined = input;
  refined.targetEdgeLength.assign(refined.points.size(), length);
  const Stopwatch watch;
  const auto report = RefineSurface(refined, {}, monitor);
  const Stopwatch::Time own = watch.Read();
  if (!report)
  {
    std::printf("refine: %s\n", report.GetError().message.c_str());
    return 1;
  }
  std::printf("%s: %zu triangles, mean edge %.4f\n", argv[1], input.triangles.size(), MeanEdgeLength(input));
  Print("Lamina", input, refined, own, monitor);
  // CGAL's edges come out shorter or longer than asked: ask again for what gives the same mean.
  double asked = length;
  Stopwatch::Time used;
  TriangleComplex remeshed;
  for (int trial = 0; trial < 3; ++trial)
  {
    remeshed = RemeshWithCgal(input, asked, used);
    const double ratio = MeanEdgeLength(refined) / MeanEdgeLength(remeshed);
    if (std::abs(ratio - 1) < 0.005)
    {
      break;
    }
    asked *= ratio;
  }
  Print("CGAL", input, remeshed, used, monitor);
  return 0;
}
