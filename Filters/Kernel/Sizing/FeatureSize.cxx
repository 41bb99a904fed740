// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureSize.h"

#include "../Mesh/Closedness.h"
#include "../Mesh/VolumeCorrection.h"
#include "Curvature.h"
#include "GradientLimit.h"
#include "SizeLimits.h"
#include "Thickness.h"

#include <algorithm>
#include <array>
#include <limits>

namespace lamina
{
namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Points x materials, NaN where a point does not touch the material; empty if cancelled.
std::vector<double> MeasureAll(const TriangleComplex& surface, const Lists& star,
                               const FeatureSizeOptions& options, const std::vector<SizeLimits>& limits,
                               FeatureSizeReport& report, Monitor& monitor)
{
  const std::size_t columns = limits.size();
  std::vector<double> thickness(surface.points.size() * columns, std::numeric_limits<double>::quiet_NaN());
  std::vector<char> below(surface.points.size(), 0);
  for (std::size_t m = 0; m < columns; ++m)
  {
    monitor.Progress(0.6 * static_cast<double>(m) / static_cast<double>(columns), "Measuring thickness");
    const double maximum = limits[m].maximum;
    const auto ids = PointsOfMaterial(surface, limits[m].material);
    auto values =
      MeasureThickness(surface, star, limits[m].material, ids, maximum, options.coneAngle, monitor);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      below[static_cast<std::size_t>(ids[i])] |= values[i] < maximum ? 1 : 0;
    }
    LimitGradient(surface.points, ids, options.gradient, values, monitor);
    if (monitor.Cancelled())
    {
      return {};
    }
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      thickness[static_cast<std::size_t>(ids[i]) * columns + m] = values[i];
    }
  }
  report.clippedAbove = std::count(below.begin(), below.end(), 0);
  return thickness;
}

/// The two materials of every point, {0, 0} where more than one sheet meets.
std::vector<MaterialPair> PairsOfPoints(const TriangleComplex& surface)
{
  std::vector<MaterialPair> pairs(surface.points.size(), { -1, -1 });
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    for (Id p : surface.triangles[t])
    {
      MaterialPair& pair = pairs[static_cast<std::size_t>(p)];
      pair = pair.first < 0 || pair == surface.materials[t] ? surface.materials[t] : MaterialPair{ 0, 0 };
    }
  }
  return pairs;
}

/// Edges come out a little longer or shorter than they should: with half of one to spare no ring of them has
/// too few.
constexpr double spareNodes = 0.5;

/// The edge length that gives a circle of a curvature its nodes.
double EdgeForCurvature(double curvature, int nodes)
{
  return nodes > 0 && curvature > 0 ? 2 * Pi / ((nodes + spareNodes) * curvature) : Infinity;
}

/// Size and edge length of every point that triangles use, before their slopes are limited.
class Governor
{
public:
  Governor(const TriangleComplex& surface, const FeatureSizeOptions& options,
           const std::vector<SizeLimits>& limits, FeatureSizeReport& report)
    : Surface(surface)
    , Options(options)
    , Pairs(PairsOfPoints(surface))
    , Limits(limits)
    , Report(report)
  {
    report.leastSize = Infinity;
  }

  void Add(const std::vector<double>& thickness, std::size_t p)
  {
    const std::size_t columns = this->Limits.size();
    const double curvature =
      std::max(std::abs(this->Surface.maximumCurvature[p]), std::abs(this->Surface.minimumCurvature[p]));
    double least = Infinity;
    double size = Infinity;
    double edge = Infinity;
    bool isRaised = false;
    bool isCurved = false;
    bool isThin = false;
    for (std::size_t m = 0; m < columns; ++m)
    {
      const double wall = thickness[p * columns + m];
      if (std::isnan(wall))
      {
        continue;
      }
      const SizeLimits& l = this->Limits[m];
      const double curved = EdgeForCurvature(std::max(curvature, this->RoundCurvature(p, l.material, wall)),
                                             this->Options.nodesPerCircumference);
      const double plain = std::clamp(wall, l.minimum, l.maximum);
      const double own = std::clamp(std::min(wall, curved / l.Ratio()), l.minimum, l.maximum);
      const double longest = this->Options.edgePerLayer * wall / l.layers;
      least = std::min(least, wall);
      size = std::min(size, own);
      edge = std::min({ edge, l.Ratio() * own, longest });
      isRaised |= wall < l.minimum;
      isCurved |= own < plain;
      isThin |= longest < l.Ratio() * own;
    }
    if (std::isfinite(least)) // else no triangle uses the point
    {
      this->Report.leastSize = std::min(this->Report.leastSize, least);
      this->Report.largestSize = std::max(this->Report.largestSize, least);
      this->Report.clippedBelow += isRaised;
      this->Report.curved += isCurved;
      this->Report.thinWalls += isThin;
      this->Ids.push_back(static_cast<Id>(p));
      this->Sizes.push_back(size);
      this->Edges.push_back(edge);
    }
  }

  std::vector<Id> Ids;
  std::vector<double> Sizes;
  std::vector<double> Edges;

private:
  /// The curvature of a tube as thick as the material if the surface bends around it nearly like one, else 0.
  /// Of a tube some voxels wide a fit sees too large a part to tell the whole of its curvature.
  double RoundCurvature(std::size_t p, int material, double wall) const
  {
    constexpr double nearly = 2.0 / 3;
    const MaterialPair& pair = this->Pairs[p];
    const double bend = pair.first == material
                          ? this->Surface.maximumCurvature[p]
                          : (pair.second == material ? -this->Surface.minimumCurvature[p] : 0);
    return bend * wall >= 2 * nearly ? 2 / wall : 0;
  }

  const TriangleComplex& Surface;
  const FeatureSizeOptions& Options;
  std::vector<MaterialPair> Pairs;
  const std::vector<SizeLimits>& Limits;
  FeatureSizeReport& Report;
};

void Govern(TriangleComplex& surface, const FeatureSizeOptions& options,
            const std::vector<SizeLimits>& limits, const std::vector<double>& thickness,
            FeatureSizeReport& report, Monitor& monitor)
{
  Governor governor(surface, options, limits, report);
  double steepest = 0;
  double loosest = 0;
  for (const SizeLimits& l : limits)
  {
    steepest = std::max(steepest, l.Ratio());
    loosest = std::max(loosest, l.maximum);
  }
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    governor.Add(thickness, p);
  }
  monitor.Progress(0.85, "Limiting the slope of the feature size");
  LimitGradient(surface.points, governor.Ids, options.gradient, governor.Sizes, monitor);
  LimitGradient(surface.points, governor.Ids, options.gradient * steepest, governor.Edges, monitor);
  // Points that no triangle uses get the largest.
  surface.featureSize.assign(surface.points.size(), loosest);
  surface.targetEdgeLength.assign(surface.points.size(), steepest * loosest);
  for (std::size_t i = 0; i < governor.Ids.size(); ++i)
  {
    surface.featureSize[static_cast<std::size_t>(governor.Ids[i])] = governor.Sizes[i];
    surface.targetEdgeLength[static_cast<std::size_t>(governor.Ids[i])] = governor.Edges[i];
  }
}

/// The fields that are written before all is known, so that a call that is stopped can put them back.
class OldFields
{
public:
  explicit OldFields(const TriangleComplex& s)
    : Fields{ s.maximumCurvature, s.minimumCurvature, s.featureSize, s.targetEdgeLength }
    , Direction(s.maximumCurvatureDirection)
  {
  }
  void PutBack(TriangleComplex& s)
  {
    s.maximumCurvature = std::move(this->Fields[0]);
    s.minimumCurvature = std::move(this->Fields[1]);
    s.featureSize = std::move(this->Fields[2]);
    s.targetEdgeLength = std::move(this->Fields[3]);
    s.maximumCurvatureDirection = std::move(this->Direction);
  }

private:
  std::array<std::vector<double>, 4> Fields;
  std::vector<Vec3> Direction;
};

/// The work on a checked surface that is not empty.
std::optional<Error> Size(TriangleComplex& surface, const FeatureSizeOptions& options,
                          const std::vector<SizeLimits>& limits, FeatureSizeReport& report, Monitor& monitor)
{
  const Lists star = TrianglesOfPoints(static_cast<Id>(surface.points.size()), surface.triangles);
  std::vector<double> thickness = MeasureAll(surface, star, options, limits, report, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  monitor.Progress(0.6, "Fitting curvatures");
  Curvatures curvatures = FitCurvatures(surface, star, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  OldFields old(surface);
  surface.maximumCurvature = std::move(curvatures.maximum);
  surface.minimumCurvature = std::move(curvatures.minimum);
  surface.maximumCurvatureDirection = std::move(curvatures.maximumDirection);
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    report.strongestCurvature = std::max({ report.strongestCurvature, std::abs(surface.maximumCurvature[p]),
                                           std::abs(surface.minimumCurvature[p]) });
  }
  Govern(surface, options, limits, thickness, report, monitor);
  if (monitor.Cancelled())
  {
    old.PutBack(surface);
    return Cancelled();
  }
  surface.sizedMaterials = report.materials;
  surface.thickness = std::move(thickness);
  return std::nullopt;
}

} // namespace

Result<FeatureSizeReport> ComputeFeatureSize(TriangleComplex& surface, const FeatureSizeOptions& options,
                                             Monitor& monitor)
{
  if (auto error = CheckOptions(options))
  {
    return *error;
  }
  // Sheets of one material that meet in an edge still have an inside.
  if (auto error = CheckClosed(surface, false, monitor))
  {
    return *error;
  }
  FeatureSizeReport report;
  if (surface.triangles.empty())
  {
    return report;
  }
  const auto limits = FindLimits(surface, options, report);
  if (!limits)
  {
    return limits.GetError();
  }
  if (auto error = CheckSides(surface, report.materials))
  {
    return *error;
  }
  if (auto error = Size(surface, options, *limits, report, monitor))
  {
    return *error;
  }
  monitor.Progress(1, "Feature size known");
  return report;
}

} // namespace lamina
