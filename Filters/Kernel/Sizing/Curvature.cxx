// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature.h"

#include "QuadricFit.h"

#include <algorithm>

namespace lamina
{
namespace
{

constexpr Id Grain = 512;
/// How far the fit reaches, in the longest mean edges of a point's surroundings (see WideEdges): about three
/// rings. A length and not a number of rings, as rings shrink where triangles do; two edges would carry the
/// residual noise of surfaces from voxels into the curvature, four round off true bends of a few edges.
constexpr double Reach = 2.75;
constexpr int WideRings = 2;
/// Points that a fit of six unknowns should have; with fewer the reach grows.
constexpr std::size_t EnoughPoints = 12;
constexpr int MostGrowths = 2;

/// Fits the sheets of one point after another.
class Fitter
{
public:
  /// `edges`: the edge length around each point.
  Fitter(const TriangleComplex& surface, const SheetNeighbours& neighbours, const Lists& star,
         const std::vector<double>& edges)
    : Surface(surface)
    , Star(star)
    , Edges(edges)
    , Stencil(surface, neighbours)
  {
  }

  PointCurvature At(Id point)
  {
    PointCurvature strongest;
    this->Done.clear();
    for (Id t : Row(this->Star, point))
    {
      if (this->Surface.Patch(t) == 0 &&
          std::find(this->Done.begin(), this->Done.end(), t) == this->Done.end())
      {
        const PointCurvature found = this->FitSheet(point, t);
        if (Norm2(strongest.direction) == 0 || found.Strongest() > strongest.Strongest())
        {
          strongest = found;
        }
      }
    }
    return strongest;
  }

private:
  /// The sheet that starts at the triangle `seed` of the point; its triangles at the point are then done.
  PointCurvature FitSheet(Id point, Id seed)
  {
    const Vec3& centre = this->Surface.points[static_cast<std::size_t>(point)];
    double reach = Reach * this->Edges[static_cast<std::size_t>(point)];
    this->Stencil.Gather(centre, seed, reach);
    for (int i = 0; i < MostGrowths && this->Stencil.Count() < EnoughPoints; ++i)
    {
      reach *= 1.5;
      this->Stencil.Gather(centre, seed, reach);
    }
    for (Id t : Row(this->Star, point))
    {
      if (this->Stencil.Has(t))
      {
        this->Done.push_back(t);
      }
    }
    return FitQuadric(this->Stencil, centre, reach, this->Scratch);
  }

  const TriangleComplex& Surface;
  const Lists& Star;
  const std::vector<double>& Edges;
  SheetStencil Stencil;
  QuadricScratch Scratch;
  std::vector<Id> Done;
};

double StarEdge(const TriangleComplex& surface, const Lists& star, Id point)
{
  double sum = 0;
  for (Id t : Row(star, point))
  {
    const Triangle& c = surface.triangles[static_cast<std::size_t>(t)];
    for (std::size_t k = 0; k < 3; ++k)
    {
      sum += Norm(surface.points[static_cast<std::size_t>(c[(k + 1) % 3])] -
                  surface.points[static_cast<std::size_t>(c[k])]);
    }
  }
  const Id count = star.Count(point);
  return count > 0 ? sum / (3.0 * static_cast<double>(count)) : 0;
}

/// The mean edge length around each point or, where that is more, around a point at most WideRings edges
/// away: edges are short at the spikes that smoothing leaves, where a fit must reach beyond them.
std::vector<double> WideEdges(const TriangleComplex& surface, const Lists& star, Monitor& monitor)
{
  const Id count = static_cast<Id>(surface.points.size());
  std::vector<double> edges(surface.points.size());
  monitor.For(count, Grain,
              [&](Id begin, Id end)
              {
                for (Id p = begin; p < end; ++p)
                {
                  edges[static_cast<std::size_t>(p)] = StarEdge(surface, star, p);
                }
              });
  for (int ring = 0; ring < WideRings; ++ring)
  {
    const std::vector<double> before = edges;
    monitor.For(count, Grain,
                [&](Id begin, Id end)
                {
                  for (Id p = begin; p < end; ++p)
                  {
                    double& edge = edges[static_cast<std::size_t>(p)];
                    for (Id t : Row(star, p))
                    {
                      for (Id q : surface.triangles[static_cast<std::size_t>(t)])
                      {
                        edge = std::max(edge, before[static_cast<std::size_t>(q)]);
                      }
                    }
                  }
                });
  }
  return edges;
}

} // namespace

Curvatures FitCurvatures(const TriangleComplex& surface, const Lists& star, Monitor& monitor)
{
  const std::size_t count = surface.points.size();
  Curvatures curvatures{ std::vector<double>(count, 0.0), std::vector<double>(count, 0.0),
                         std::vector<Vec3>(count) };
  const SheetNeighbours neighbours = FindSheetNeighbours(surface, star, monitor);
  const std::vector<double> edges = WideEdges(surface, star, monitor);
  if (monitor.Cancelled())
  {
    return curvatures;
  }
  monitor.For(static_cast<Id>(count), Grain,
              [&](Id begin, Id end)
              {
                Fitter fitter(surface, neighbours, star, edges);
                for (Id p = begin; p < end; ++p)
                {
                  const PointCurvature found = fitter.At(p);
                  curvatures.maximum[static_cast<std::size_t>(p)] = found.maximum;
                  curvatures.minimum[static_cast<std::size_t>(p)] = found.minimum;
                  curvatures.maximumDirection[static_cast<std::size_t>(p)] = found.direction;
                }
              });
  return curvatures;
}

} // namespace lamina
