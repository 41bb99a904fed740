// SPDX-License-Identifier: BSD-3-Clause
// The promises of refinement, measured independently of it from the surfaces before and after.
#pragma once

#include "Geometry/Quality.h"
#include "Geometry/VisibleDirection.h"
#include "Mesh/JunctionGraph.h"
#include "Mesh/VolumeCorrection.h"
#include "RefinementGaps.h"
#include "Search/SelfIntersection.h"
#include "Surface/RefineSurface.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

namespace lamina::measures
{

constexpr double degree = 3.14159265358979323846 / 180;

struct Farthest
{
  double ratio = 0; ///< distance over tolerance
  double distance = 0;
  Id above = 0;   ///< triangles with a sample beyond the tolerance
  Id corners = 0; ///< and those of them where a corner is
  Vec3 place;
};

/// What is promised of a refined surface, as it was measured.
struct RefinementFigures
{
  double edgesInRange = 0;  ///< share within [0.5, 1.5] of their target
  double goodTriangles = 0; ///< share with 2r/R of 0.4 or more
  Id badTriangles = 0;      ///< below 0.3
  double leastQuality = 1;
  Id exempt =
    0;          ///< poor triangles in corners of less than 20 degrees between fixed curves, not counted above
  Farthest out; ///< of the output from the input
  Farthest back;           ///< of the input from the output
  double volume = 0;       ///< largest relative change of a material
  Id eulerNumbers = 0;     ///< that changed, of the whole and of materials
  bool piecesKept = false; ///< as many sheets and shells
  Id intersections = 0;
  Id hidden = 0; ///< nodes without a direction
  Nearness nearBefore;
  Nearness nearAfter;
  Id narrowed = 0; ///< pairs of triangles nearer than the sheets may come
};

/// How many equilateral triangles of the targets cover the surface.
inline double EquilateralTriangles(const TriangleComplex& s)
{
  double count = 0;
  for (const Triangle& t : s.triangles)
  {
    double h = 0;
    for (Id p : t)
    {
      h += s.targetEdgeLength[static_cast<std::size_t>(p)] / 3;
    }
    count += 0.5 * Norm(AreaVector2(s.points, t)) / (std::sqrt(3.0) / 4 * h * h);
  }
  return count;
}

inline void MeasureEdges(const TriangleComplex& s, RefinementFigures& figures)
{
  const EdgeTable table = MakeEdgeTable(s.triangles);
  Id shorter = 0;
  Id longer = 0;
  double least = 1e300;
  double most = 0;
  for (const Edge& e : table.edges)
  {
    const double h = 0.5 * (s.targetEdgeLength[static_cast<std::size_t>(e.a)] +
                            s.targetEdgeLength[static_cast<std::size_t>(e.b)]);
    const double r = Norm(At(s, e.a) - At(s, e.b)) / h;
    least = std::min(least, r);
    most = std::max(most, r);
    shorter += r < 0.5;
    longer += r > 1.5;
  }
  const auto count = static_cast<double>(table.edges.size());
  figures.edgesInRange = 1 - static_cast<double>(shorter + longer) / count;
  std::printf("  edges in [0.5, 1.5]: %.3f %% (%lld below, %lld above; %.2f to %.2f)\n",
              100 * figures.edgesInRange, shorter, longer, least, most);
}

/// Triangles that lie in a corner of less than 20 degrees between two feature edges.
inline std::vector<char> Exempt(const TriangleComplex& s)
{
  const EdgeTable table = MakeEdgeTable(s.triangles);
  const std::vector<char> feature = FeatureEdges(s, table);
  std::map<std::pair<Id, Id>, bool> isFeature;
  std::set<Id> onFeature;
  for (std::size_t e = 0; e < table.edges.size(); ++e)
  {
    if (feature[e])
    {
      isFeature[{ table.edges[e].a, table.edges[e].b }] = true;
      onFeature.insert(table.edges[e].a);
      onFeature.insert(table.edges[e].b);
    }
  }
  const auto is = [&](Id a, Id b) { return isFeature.count({ std::min(a, b), std::max(a, b) }) > 0; };
  std::vector<char> exempt(s.triangles.size(), 0);
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id p = s.triangles[t][k];
      const Id a = s.triangles[t][(k + 1) % 3];
      const Id b = s.triangles[t][(k + 2) % 3];
      if (onFeature.count(p) && is(p, a) && is(p, b))
      {
        const double angle = std::acos(std::max(
          -1.0, std::min(1.0, Dot(Normalized(At(s, a) - At(s, p)), Normalized(At(s, b) - At(s, p))))));
        exempt[t] = exempt[t] || angle < 20 * degree;
      }
    }
  }
  return exempt;
}

inline void MeasureQuality(const TriangleComplex& s, bool verbose, RefinementFigures& figures)
{
  const std::vector<char> exempt = Exempt(s);
  Id poor = 0;
  Id bad = 0;
  Id excused = 0;
  double least = 1;
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
  {
    const Triangle& c = s.triangles[t];
    const double q = TriangleQuality(At(s, c[0]), At(s, c[1]), At(s, c[2]));
    if (q < 0.4 && exempt[t])
    {
      ++excused;
      continue;
    }
    least = std::min(least, q);
    poor += q < 0.4;
    bad += q < 0.3;
    if (verbose && q < 0.3)
    {
      std::printf("    q %.3f at (%.2f %.2f %.2f) kinds %d %d %d\n", q, At(s, c[0]).x, At(s, c[0]).y,
                  At(s, c[0]).z, s.junctionKind[static_cast<std::size_t>(c[0])],
                  s.junctionKind[static_cast<std::size_t>(c[1])],
                  s.junctionKind[static_cast<std::size_t>(c[2])]);
    }
  }
  figures.goodTriangles = 1 - static_cast<double>(poor) / static_cast<double>(s.triangles.size());
  figures.badTriangles = bad;
  figures.leastQuality = least;
  figures.exempt = excused;
  std::printf("  quality: %.4f %% >= 0.4 (%lld below), %lld below 0.3, least %.3f, %lld exempt\n",
              100 * figures.goodTriangles, poor, bad, least, excused);
}

/// How far samples of `from` lie from the same sheets of `to`, against `tolerance` at triangle and weights of
/// the input, which is `to` or `from`.
template<typename Tolerance>
Farthest FindFarthest(const TriangleComplex& from, const TriangleComplex& to, bool toIsInput,
                      Tolerance&& tolerance, Monitor& monitor)
{
  static const std::vector<std::array<double, 3>> samples = []
  {
    std::vector<std::array<double, 3>> all;
    for (int i = 0; i <= 4; ++i)
    {
      for (int j = 0; i + j <= 4; ++j)
      {
        all.push_back({ { i / 4.0, j / 4.0, (4 - i - j) / 4.0 } });
      }
    }
    all.push_back({ { 1 / 3.0, 1 / 3.0, 1 / 3.0 } });
    return all;
  }();
  const Sheets own(from);
  const Sheets sheets(to);
  const auto count = static_cast<Id>(from.triangles.size());
  std::vector<Farthest> each(static_cast<std::size_t>(count));
  monitor.For(count, 512,
              [&](Id begin, Id end)
              {
                for (Id t = begin; t < end; ++t)
                {
                  const auto v = static_cast<std::size_t>(t);
                  const Triangle& c = from.triangles[v];
                  const TriangleTree* tree = sheets.Tree(own.KeyOf(v));
                  for (const auto& w : samples)
                  {
                    const Vec3 x = w[0] * At(from, c[0]) + w[1] * At(from, c[1]) + w[2] * At(from, c[2]);
                    const auto place = tree ? tree->ClosestPoint(x) : TriangleTree::Closest{};
                    const double d = std::sqrt(place.distance2);
                    const double r =
                      d / (toIsInput ? tolerance(place.triangle, place.weights) : tolerance(t, w));
                    each[v].distance = std::max(each[v].distance, d);
                    each[v].above = each[v].above || r > 1;
                    each[v].corners = each[v].corners || (r > 1 && (w[0] == 1 || w[1] == 1 || w[2] == 1));
                    if (r > each[v].ratio)
                    {
                      each[v].ratio = r;
                      each[v].place = x;
                    }
                  }
                }
              });
  Farthest all;
  for (const Farthest& f : each)
  {
    all.above += f.above;
    all.corners += f.corners;
    all.distance = std::max(all.distance, f.distance);
    if (f.ratio > all.ratio)
    {
      all.ratio = f.ratio;
      all.place = f.place;
    }
  }
  return all;
}

inline void MeasureDistances(const TriangleComplex& before, const TriangleComplex& after,
                             const RefineSurfaceOptions& options, double voxel, RefinementFigures& figures,
                             Monitor& monitor)
{
  const double widest = voxel > 0 ? 0.5 * voxel : 0.7 * MeanEdgeLength(before);
  const auto tolerance = [&](Id t, const std::array<double, 3>& w)
  {
    if (options.tolerance > 0)
    {
      return options.tolerance;
    }
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      size +=
        w[k] * before.featureSize[static_cast<std::size_t>(before.triangles[static_cast<std::size_t>(t)][k])];
    }
    return std::min(0.1 * size, widest);
  };
  const Farthest& out = figures.out = FindFarthest(after, before, true, tolerance, monitor);
  const Farthest& back = figures.back = FindFarthest(before, after, false, tolerance, monitor);
  std::printf("  distance: to input %.2f tolerances (%lld triangles above, %lld at a corner, %.4f, at %.1f "
              "%.1f %.1f), from input "
              "%.2f (%lld, %lld, %.4f, at %.1f %.1f %.1f)\n",
              out.ratio, out.above, out.corners, out.distance, out.place.x, out.place.y, out.place.z,
              back.ratio, back.above, back.corners, back.distance, back.place.x, back.place.y, back.place.z);
}

inline Id EulerNumber(const TriangleComplex& s, int material)
{
  std::vector<Triangle> own;
  std::set<Id> used;
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
  {
    if (material < 0 || SideOf(s.materials[t], material) != 0)
    {
      own.push_back(s.triangles[t]);
      used.insert(s.triangles[t].begin(), s.triangles[t].end());
    }
  }
  return static_cast<Id>(used.size()) - static_cast<Id>(MakeEdgeTable(own).edges.size()) +
         static_cast<Id>(own.size());
}

inline void MeasureTopology(const TriangleComplex& before, const TriangleComplex& after,
                            RefinementFigures& figures, Monitor& monitor)
{
  const std::vector<int> materials = MaterialsOf(before);
  const std::vector<double> old = MaterialVolumes(before, materials);
  const std::vector<double> now = MaterialVolumes(after, materials);
  double worst = 0;
  Id changed = EulerNumber(before, -1) != EulerNumber(after, -1);
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    worst = std::max(worst, std::abs(now[m] / old[m] - 1));
    changed += EulerNumber(before, materials[m]) != EulerNumber(after, materials[m]);
  }
  const SheetGraph was = MakeSheetGraph(before);
  const SheetGraph is = MakeSheetGraph(after);
  figures.volume = worst;
  figures.eulerNumbers = changed;
  figures.piecesKept =
    was.shellsOfSheet.size() == is.shellsOfSheet.size() && was.ShellCount() == is.ShellCount();
  figures.intersections = static_cast<Id>(FindIntersections(after.points, after.triangles, monitor).size());
  std::printf(
    "  volumes: %.1e; Euler numbers changed: %lld; sheets %zu -> %zu, shells %d -> %d; intersections: "
    "%lld\n",
    worst, changed, was.shellsOfSheet.size(), is.shellsOfSheet.size(), was.ShellCount(), is.ShellCount(),
    figures.intersections);
}

/// The least, over the materials at each point, of the cosine with which the best direction sees all faces.
inline std::vector<double> Sights(const TriangleComplex& s, Monitor& monitor)
{
  const auto count = static_cast<Id>(s.points.size());
  const Lists star = TrianglesOfPoints(count, s.triangles);
  std::vector<double> sights(s.points.size(), 1);
  monitor.For(count, 1024,
              [&](Id begin, Id end)
              {
                for (Id p = begin; p < end; ++p)
                {
                  std::set<int> materials;
                  for (Id t : Row(star, p))
                  {
                    materials.insert(s.materials[static_cast<std::size_t>(t)].first);
                    materials.insert(s.materials[static_cast<std::size_t>(t)].second);
                  }
                  materials.erase(0);
                  for (int material : materials)
                  {
                    std::vector<Vec3> normals;
                    for (Id t : Row(star, p))
                    {
                      const int side = SideOf(s.materials[static_cast<std::size_t>(t)], material);
                      if (side != 0)
                      {
                        normals.push_back(
                          side * Normalized(AreaVector2(s.points, s.triangles[static_cast<std::size_t>(t)])));
                      }
                    }
                    sights[static_cast<std::size_t>(p)] = std::min(sights[static_cast<std::size_t>(p)],
                                                                   FindVisibleDirection(normals).leastCosine);
                  }
                }
              });
  return sights;
}

inline void MeasureSights(const TriangleComplex& before, const TriangleComplex& after, bool verbose,
                          RefinementFigures& figures, Monitor& monitor)
{
  const std::vector<double> old = Sights(before, monitor);
  const std::vector<double> now = Sights(after, monitor);
  const auto hidden = [](const std::vector<double>& sights)
  { return std::count_if(sights.begin(), sights.end(), [](double c) { return c < 0.4; }); };
  Id onSheets = 0;
  for (std::size_t p = 0; p < now.size(); ++p)
  {
    if (now[p] < 0.4)
    {
      onSheets += after.junctionKind[p] == JunctionSheet;
      if (verbose)
      {
        std::printf("    sight %.3f kind %d at (%.2f %.2f %.2f)\n", now[p], after.junctionKind[p],
                    after.points[p].x, after.points[p].y, after.points[p].z);
      }
    }
  }
  figures.hidden = hidden(now);
  std::printf(
    "  nodes without a direction: %lld of %zu (%lld on sheets, least cosine %.3f); in the input %lld\n",
    static_cast<Id>(hidden(now)), now.size(), onSheets, *std::min_element(now.begin(), now.end()),
    static_cast<Id>(hidden(old)));
}

/// Measures and prints it all. `voxel`: the least spacing of the image that the surface is from, or 0.
inline RefinementFigures Measure(const TriangleComplex& before, const TriangleComplex& after,
                                 const RefineSurfaceOptions& options, double voxel, bool verbose,
                                 Monitor& monitor)
{
  RefinementFigures figures;
  MeasureEdges(after, figures);
  MeasureQuality(after, verbose, figures);
  MeasureDistances(before, after, options, voxel, figures, monitor);
  MeasureTopology(before, after, figures, monitor);
  MeasureSights(before, after, verbose, figures, monitor);
  const Nearness& was = figures.nearBefore = MeasureNearness(before, voxel, monitor);
  const Nearness& is = figures.nearAfter = MeasureNearness(after, voxel, monitor);
  std::printf(
    "  sheets: least distance %.3f -> %.3f %s, below a quarter at %lld -> %lld points; least angle %.1f -> "
    "%.1f degrees\n",
    was.gap, is.gap, voxel > 0 ? "voxels" : "targets", was.near, is.near, was.angle, is.angle);
  figures.narrowed = CountNarrowed(before, after, voxel, monitor);
  std::fflush(stdout);
  return figures;
}

} // namespace lamina::measures
