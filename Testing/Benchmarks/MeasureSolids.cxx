// SPDX-License-Identifier: BSD-3-Clause
// What Layered Tetrahedra promises, measured on a given surface: MeasureSolids FILE SOLIDS [NAME=VALUE]...
//
// FILE: .labels or .surface, as WriteRefinementInputs.py makes them. SOLIDS: ids with commas. NAME: threads,
// layers (6), anisotropy (2), growth (1), minimum, maximum, scale (of the targets), rays (20000), program
// (the child; else TetGen runs inside), verbose (where bad tets are).
#include "../Kernel/LayerRays.h"
#include "Geometry/Quality.h"
#include "Search/TriangleTree.h"
#include "SizedSurfaces.h"
#include "Surface/RefineSurface.h"
#include "Volume/LayeredTets.h"

#include <chrono>
#include <cmath>
#include <ctime>
#include <iterator>
#include <map>
#include <sstream>
#include <sys/resource.h>

using namespace lamina;

namespace
{

constexpr double poor = 0.1;
constexpr double fair = 0.2;

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

std::vector<int> Numbers(const std::string& text)
{
  std::vector<int> numbers;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');)
  {
    numbers.push_back(std::atoi(word.c_str()));
  }
  return numbers;
}

std::array<Vec3, 4> Corners(const VolumeMesh& mesh, Id cell)
{
  const Id* n = mesh.Cell(cell);
  return { { mesh.points[U(n[0])], mesh.points[U(n[1])], mesh.points[U(n[2])], mesh.points[U(n[3])] } };
}

double AngleAt(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  const Vec3 along = (b - a) * (1 / Norm(b - a));
  const auto across = [&](const Vec3& x) { return (x - a) - Dot(x - a, along) * along; };
  const Vec3 u = across(c);
  const Vec3 v = across(d);
  return std::atan2(Norm(Cross(u, v)), Dot(u, v)) * 180 / 3.14159265358979;
}

/// The angle of the material at an edge that lies on its boundary, and how many tets share it; 0 inside.
std::pair<double, int> WedgeAt(const VolumeMesh& mesh, int material, Id a, Id b)
{
  double sum = 0;
  int count = 0;
  std::map<Id, int> others;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    const Id* n = mesh.Cell(c);
    if (mesh.materials[U(c)] != material || std::count(n, n + 4, a) == 0 || std::count(n, n + 4, b) == 0)
    {
      continue;
    }
    std::vector<Id> rest;
    std::copy_if(n, n + 4, std::back_inserter(rest), [&](Id x) { return x != a && x != b; });
    sum += AngleAt(mesh.points[U(a)], mesh.points[U(b)], mesh.points[U(rest[0])], mesh.points[U(rest[1])]);
    ++count;
    ++others[rest[0]];
    ++others[rest[1]];
  }
  const bool isOpen =
    std::any_of(others.begin(), others.end(), [](const auto& other) { return other.second == 1; });
  return { isOpen ? sum : 0, count };
}

void PrintTet(const VolumeMesh& mesh, Id cell, double quality, bool isListed)
{
  const Vec3 place = Corners(mesh, cell)[0];
  std::printf("    %.4f at %.4f %.4f %.4f, material %d, LayerIndex", quality, place.x, place.y, place.z,
              mesh.materials[U(cell)]);
  for (int k = 0; k < 4; ++k)
  {
    std::printf(" %d", mesh.layerIndex[U(mesh.Cell(cell)[k])]);
  }
  std::printf("%s\n     ", isListed ? ", at a hidden node" : "");
  const Id* n = mesh.Cell(cell);
  for (int i = 0; i < 4; ++i)
  {
    for (int j = i + 1; j < 4; ++j)
    {
      const auto [wedge, tets] = WedgeAt(mesh, mesh.materials[U(cell)], n[i], n[j]);
      int k = 0;
      while (k == i || k == j)
      {
        ++k;
      }
      const int l = 6 - i - j - k;
      std::printf(
        " %d-%d: length %.3f angle %.0f", i, j, Norm(mesh.points[U(n[i])] - mesh.points[U(n[j])]),
        AngleAt(mesh.points[U(n[i])], mesh.points[U(n[j])], mesh.points[U(n[k])], mesh.points[U(n[l])]));
      if (wedge > 0)
      {
        std::printf(" of %.0f in %d tets", wedge, tets);
      }
      std::printf(";");
    }
  }
  std::printf("\n");
}

/// Quality of all tets, and which of the poor ones touch a node that refinement listed as hidden.
void PrintQuality(const VolumeMesh& mesh, const std::vector<Id>& hidden, bool verbose)
{
  double least = 1;
  Id below[2] = { 0, 0 };
  Id listed = 0;
  Id badAngles = 0;
  Id skipping = 0;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    const auto p = Corners(mesh, c);
    const double quality = TetQuality(p[0], p[1], p[2], p[3]);
    const auto angles = TetDihedralAngles(p[0], p[1], p[2], p[3]);
    badAngles += angles[0] < 8 || angles[1] > 170 ? 1 : 0;
    least = std::min(least, quality);
    below[0] += quality <= poor ? 1 : 0;
    below[1] += quality <= fair ? 1 : 0;
    int low = 1 << 30;
    int high = 0;
    bool touches = false;
    for (int k = 0; k < 4; ++k)
    {
      const Id n = mesh.Cell(c)[k];
      const int layer = mesh.layerIndex[U(n)];
      low = layer < 0 ? low : std::min(low, layer);
      high = std::max(high, layer);
      touches = touches || std::binary_search(hidden.begin(), hidden.end(), mesh.interfaceNodeIds[U(n)]);
    }
    skipping += high - low > 1 ? 1 : 0;
    listed += quality <= poor && touches ? 1 : 0;
    if (verbose && (quality <= poor || high - low > 1))
    {
      PrintTet(mesh, c, quality, touches);
    }
  }
  std::printf("  least 3r/R %.4f; at most 0.1: %lld (%lld at hidden nodes), at most 0.2: %lld\n", least,
              below[0], listed, below[1]);
  std::printf("  tets with angles outside of 8 to 170 degrees: %lld (%.4f %%); with layers two apart: %lld\n",
              badAngles, 100.0 * static_cast<double>(badAngles) / static_cast<double>(mesh.CellCount()),
              skipping);
}

/// The metric of the layers round a wall's triangles: lengths across count by how much longer the edges along
/// the wall are than the layers are thick, at most the anisotropy asked for.
class LayerMetric
{
public:
  LayerMetric(const TriangleComplex& surface, const LayeredTetsOptions& options)
    : Surface(surface)
    , Options(options)
    , Tree(surface.points, surface.triangles)
  {
  }

  std::array<Vec3, 4> Stretched(std::array<Vec3, 4> corners, int material) const
  {
    const Vec3 centre = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    const Id t = this->Tree.ClosestPoint(centre).triangle;
    const Triangle& c = this->Surface.triangles[U(t)];
    const auto& sized = this->Surface.sizedMaterials;
    const std::size_t column =
      static_cast<std::size_t>(std::find(sized.begin(), sized.end(), material) - sized.begin());
    double edge = 0;
    double thickness = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      edge += Norm(this->Surface.points[U(c[k])] - this->Surface.points[U(c[(k + 1) % 3])]) / 3;
      thickness += this->Surface.thickness[U(c[k]) * sized.size() + column] / 3;
    }
    // NaN where the nearest wall is another material's.
    const double wanted = edge * this->Options.layers / thickness;
    const double factor = wanted > 1 ? std::min(wanted, this->Options.anisotropy) : 1;
    const Vec3 normal = Normalized(AreaVector2(this->Surface.points, c));
    for (Vec3& p : corners)
    {
      p += (factor - 1) * Dot(p - centre, normal) * normal;
    }
    return corners;
  }

private:
  const TriangleComplex& Surface;
  const LayeredTetsOptions& Options;
  TriangleTree Tree;
};

/// Of the tets in columns: the core has no layers.
void PrintLayerQuality(const VolumeMesh& mesh, const LayerMetric& metric)
{
  double least = 1;
  Id below = 0;
  Id badAngles = 0;
  Id count = 0;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    if (mesh.layers[U(c)] == 0)
    {
      continue;
    }
    ++count;
    const auto p = metric.Stretched(Corners(mesh, c), mesh.materials[U(c)]);
    const double quality = TetQuality(p[0], p[1], p[2], p[3]);
    const auto angles = TetDihedralAngles(p[0], p[1], p[2], p[3]);
    least = std::min(least, quality);
    below += quality <= poor ? 1 : 0;
    badAngles += angles[0] < 8 || angles[1] > 170 ? 1 : 0;
  }
  std::printf(
    "  in the layers' metric, %lld tets of columns: least %.4f; at most 0.1: %lld; angles out of range: "
    "%lld (%.4f %%)\n",
    count, least, below, badAngles,
    100.0 * static_cast<double>(badAngles) / static_cast<double>(std::max<Id>(1, count)));
}

/// Volume against the surface, and the surface's triangles as faces.
void PrintFit(const TriangleComplex& surface, const VolumeMesh& mesh, const std::vector<int>& solids,
              Monitor& monitor)
{
  const CellFaces faces = FindCellFaces(mesh, monitor);
  std::vector<Id> nodeOf(surface.points.size(), -1);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    if (mesh.interfaceNodeIds[p] >= 0)
    {
      nodeOf[U(mesh.interfaceNodeIds[p])] = static_cast<Id>(p);
    }
  }
  Id wrong = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Triangle& c = surface.triangles[t];
    std::size_t sides = 0;
    for (const int material : solids)
    {
      sides += SideOf(surface.materials[t], material) != 0 ? 1 : 0;
    }
    const Id group = sides > 0 ? faces.Find({ { nodeOf[U(c[0])], nodeOf[U(c[1])], nodeOf[U(c[2])] } }) : -1;
    const std::size_t found = group < 0 ? 0 : faces.start[U(group) + 1] - faces.start[U(group)];
    wrong += found == sides ? 0 : 1;
  }
  const std::vector<double> enclosed = MaterialVolumes(surface, solids);
  double worst = 0;
  for (std::size_t m = 0; m < solids.size(); ++m)
  {
    double sum = 0;
    for (Id c = 0; c < mesh.CellCount(); ++c)
    {
      const auto p = Corners(mesh, c);
      sum += mesh.materials[U(c)] == solids[m] ? TetVolume(p[0], p[1], p[2], p[3]) : 0;
    }
    worst = std::max(worst, std::abs(sum / enclosed[m] - 1));
  }
  std::printf("  volumes off by %.1e; triangles without one tet for each solid: %lld\n", worst, wrong);
}

void PrintRays(const TriangleComplex& surface, const VolumeMesh& mesh, const LayersOnSurface& onSurface,
               const LayeredTetsOptions& options, Id count)
{
  const auto sizes = std::minmax_element(surface.featureSize.begin(), surface.featureSize.end());
  layers::RayCount all;
  for (const int material : options.materials)
  {
    const layers::RayCount rays = layers::CountRays(
      surface, mesh, onSurface, material, (options.layers - 1) / 2, count, *sizes.first, *sizes.second);
    all.rays += rays.rays;
    all.whole += rays.whole;
    all.flagged += rays.flagged;
  }
  std::printf("  rays %lld, whole %lld, of the others flagged %lld\n", all.rays, all.whole, all.flagged);
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 3)
  {
    std::printf("MeasureSolids FILE SOLIDS [NAME=VALUE]...\n");
    return 1;
  }
  const Arguments arguments(argc, argv);
  const std::string path = argv[1];
  ThreadMonitor monitor(static_cast<int>(arguments.Get("threads", 2)));
  double voxel = 0;
  TriangleComplex surface = measures::Sized(path, arguments, voxel, monitor);
  for (double& target : surface.targetEdgeLength)
  {
    target *= arguments.Get("scale", 1);
  }
  const auto refined = RefineSurface(surface, {}, monitor);
  measures::Demand(refined, "refine");
  LayeredTetsOptions options;
  options.materials = Numbers(argv[2]);
  options.layers = static_cast<int>(arguments.Get("layers", options.layers));
  options.anisotropy = arguments.Get("anisotropy", options.anisotropy);
  options.growth = arguments.Get("growth", options.growth);
  options.core.program = arguments.Text("program");
  VolumeMesh mesh;
  LayersOnSurface onSurface;
  const std::clock_t clock = std::clock();
  const auto begin = std::chrono::steady_clock::now();
  const auto report = MeshLayeredTets(surface, options, mesh, onSurface, monitor);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  measures::Demand(report, "layers");
  rusage memory{};
  getrusage(RUSAGE_SELF, &memory);
  std::printf(
    "%s, %d layers, anisotropy %g: %zu triangles -> %lld tets, %.1f s (%.1f s of processors), %.2f GiB\n",
    path.c_str(), options.layers, options.anisotropy, surface.triangles.size(), mesh.CellCount(), seconds,
    static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC,
    static_cast<double>(memory.ru_maxrss) / (1 << 20));
  std::printf("  columns %lld: thinned %lld, stopped %lld, shortened %lld; hidden nodes %zu\n",
              report->columns, report->thinnedColumns, report->stoppedColumns, report->shortenedColumns,
              refined->hiddenPoints.size());
  PrintQuality(mesh, refined->hiddenPoints, arguments.Get("verbose", 0) > 0);
  PrintLayerQuality(mesh, LayerMetric(surface, options));
  PrintFit(surface, mesh, options.materials, monitor);
  PrintRays(surface, mesh, onSurface, options, static_cast<Id>(arguments.Get("rays", 20000)));
  return 0;
}
