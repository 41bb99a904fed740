// SPDX-License-Identifier: BSD-3-Clause
// A label image meshed by CGAL's Mesh_3, for ComparePeers.py: MeshByCgal FILE OUTPUT size=LENGTH
//
// FILE: .labels, as WriteRefinementInputs.py makes them. The triangulation is initialised from the image, so that no
// component of it is left out from the start; perturbation and exudation follow as by default. With TBB it runs in
// parallel.
#include "Arguments.h"
#include "PeerFiles.h"
#include "RefinementFiles.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Image_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_3/initialize_triangulation_from_labeled_image.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>

#include <cstdio>
#include <map>

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
#ifdef CGAL_CONCURRENT_MESH_3
using Concurrency = CGAL::Parallel_tag;
#else
using Concurrency = CGAL::Sequential_tag;
#endif
using Triangulation = CGAL::Mesh_triangulation_3<Domain, CGAL::Default, Concurrency>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

CGAL::Image_3 ReadLabels(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const auto size = lamina::Take<lamina::Id>(file, 3);
  const auto spacing = lamina::Take<double>(file, 3);
  const auto count = static_cast<std::size_t>(size[0] * size[1] * size[2]);
  const auto labels = lamina::Take<int>(file, count);
  _image* image =
    _createImage(static_cast<std::size_t>(size[0]), static_cast<std::size_t>(size[1]),
                 static_cast<std::size_t>(size[2]), 1, spacing[0], spacing[1], spacing[2], 1, WK_FIXED, SGN_UNSIGNED);
  auto* voxels = static_cast<unsigned char*>(image->data);
  for (std::size_t i = 0; i < count; ++i)
  {
    voxels[i] = static_cast<unsigned char>(labels[i]);
  }
  return CGAL::Image_3(image, CGAL::Image_3::OWN_THE_DATA);
}

bool Write(const Complex& complex, const std::string& path)
{
  std::map<Triangulation::Vertex_handle, lamina::Id> ids;
  std::vector<lamina::Vec3> points;
  std::vector<std::array<lamina::Id, 4>> tets;
  std::vector<int> materials;
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell)
  {
    std::array<lamina::Id, 4> tet{};
    for (int k = 0; k < 4; ++k)
    {
      const auto vertex = cell->vertex(k);
      const auto [entry, isNew] = ids.emplace(vertex, static_cast<lamina::Id>(points.size()));
      if (isNew)
      {
        const auto& p = vertex->point();
        points.push_back({ CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()) });
      }
      tet[static_cast<std::size_t>(k)] = entry->second;
    }
    tets.push_back(tet);
    materials.push_back(static_cast<int>(complex.subdomain_index(cell)));
  }
  return lamina::WritePeerMesh(path, points, tets, materials);
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 4)
  {
    std::printf("MeshByCgal FILE OUTPUT size=LENGTH\n");
    return 1;
  }
  const lamina::Arguments arguments(argc, argv);
  const double size = arguments.Get("size", 0);
  const CGAL::Image_3 image = ReadLabels(argv[1]);
  const Domain domain = Domain::create_labeled_image_mesh_domain(image);
  // Sizes are circumradii; a surface is at most a tenth of an edge off.
  namespace parameters = CGAL::parameters;
  const Criteria criteria(parameters::facet_angle = 30, parameters::facet_size = size,
                          parameters::facet_distance = 0.1 * size, parameters::cell_radius_edge_ratio = 2,
                          parameters::cell_size = size);
  Complex complex;
  initialize_triangulation_from_labeled_image(complex, domain, image, criteria, static_cast<unsigned char>(0));
  CGAL::refine_mesh_3(complex, domain, criteria);
  std::printf("%zu tets%s\n", static_cast<std::size_t>(complex.number_of_cells_in_complex()),
              std::is_same<Concurrency, CGAL::Parallel_tag>::value ? ", in parallel" : "");
  return Write(complex, argv[2]) ? 0 : 1;
}
