// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureSize.h"

#include "../Mesh/Closedness.h"
#include "GradientLimit.h"
#include "Thickness.h"

#include <algorithm>
#include <limits>

namespace lamina
{
namespace
{

std::string OutOfRange(const char* option, double value, const char* range)
{
  return std::string(option) + " is " + std::to_string(value) + ", but must be " + range;
}

std::optional<Error> CheckOptions(const FeatureSizeOptions& o)
{
  // Written so that NaN fails.
  const auto isLength = [](double value) { return value >= 0 && std::isfinite(value); };
  const auto isPositive = [](double value) { return value > 0 && std::isfinite(value); };
  if (!isLength(o.minimum))
  {
    return InvalidOption(OutOfRange("minimum", o.minimum, "a length of 0 (automatic) or more"));
  }
  if (!isLength(o.maximum))
  {
    return InvalidOption(OutOfRange("maximum", o.maximum, "a length of 0 (automatic) or more"));
  }
  if (!isPositive(o.gradient))
  {
    return InvalidOption(OutOfRange("gradient", o.gradient, "above 0"));
  }
  if (o.layers < 1)
  {
    return InvalidOption(OutOfRange("layers", o.layers, "1 or more"));
  }
  if (!isPositive(o.anisotropy))
  {
    return InvalidOption(OutOfRange("anisotropy", o.anisotropy, "above 0"));
  }
  if (!(o.coneAngle >= 0 && o.coneAngle <= 60))
  {
    return InvalidOption(OutOfRange("coneAngle", o.coneAngle, "in [0, 60] degrees"));
  }
  return std::nullopt;
}

/// The limits in use, from the options or from the mean edge length.
std::optional<Error> FindLimits(const TriangleComplex& surface, const FeatureSizeOptions& options,
                                FeatureSizeReport& report)
{
  const double edge = MeanEdgeLength(surface);
  if (!(edge > 0))
  {
    return InvalidInput("all points of the surface coincide", { surface.points.front() });
  }
  report.minimum = options.minimum > 0 ? options.minimum : 2.6 * edge;
  report.maximum = options.maximum > 0 ? options.maximum : 20 * edge;
  if (report.minimum > report.maximum)
  {
    return InvalidOption("the least feature size (" + std::to_string(report.minimum) +
                         ") is above the largest (" + std::to_string(report.maximum) +
                         "); 0 takes 2.6 and 20 mean edge lengths of " + std::to_string(edge));
  }
  return std::nullopt;
}

/// Points x materials, NaN where a point does not touch the material; empty if cancelled.
std::vector<double> MeasureAll(const TriangleComplex& surface, const FeatureSizeOptions& options,
                               const FeatureSizeReport& report, std::vector<double>& raw, Monitor& monitor)
{
  const Lists star = TrianglesOfPoints(static_cast<Id>(surface.points.size()), surface.triangles);
  const std::size_t columns = report.materials.size();
  std::vector<double> thickness(surface.points.size() * columns, std::numeric_limits<double>::quiet_NaN());
  raw.assign(surface.points.size(), report.maximum);
  for (std::size_t m = 0; m < columns; ++m)
  {
    monitor.Progress(0.9 * static_cast<double>(m) / static_cast<double>(columns), "Measuring thickness");
    const auto ids = PointsOfMaterial(surface, report.materials[m]);
    auto values =
      MeasureThickness(surface, star, report.materials[m], ids, report.maximum, options.coneAngle, monitor);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      double& least = raw[static_cast<std::size_t>(ids[i])];
      least = std::min(least, values[i]);
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
  return thickness;
}

/// The governing size of each point: the least of its materials, clipped, then limited over all points.
std::vector<double> Govern(const TriangleComplex& surface, const FeatureSizeOptions& options,
                           const std::vector<double>& thickness, FeatureSizeReport& report, Monitor& monitor)
{
  const std::size_t columns = report.materials.size();
  std::vector<double> size(surface.points.size(), report.maximum);
  std::vector<Id> ids;
  std::vector<double> values;
  report.leastSize = std::numeric_limits<double>::infinity();
  report.largestSize = 0;
  for (std::size_t p = 0; p < size.size(); ++p)
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t m = 0; m < columns; ++m)
    {
      least = std::fmin(least, thickness[p * columns + m]);
    }
    if (std::isfinite(least)) // else no triangle uses the point
    {
      report.leastSize = std::min(report.leastSize, least);
      report.largestSize = std::max(report.largestSize, least);
      report.clippedBelow += least < report.minimum;
      ids.push_back(static_cast<Id>(p));
      values.push_back(std::clamp(least, report.minimum, report.maximum));
    }
  }
  LimitGradient(surface.points, ids, options.gradient, values, monitor);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    size[static_cast<std::size_t>(ids[i])] = values[i];
  }
  return size;
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
  std::vector<double> size(surface.points.size(), 0.0);
  std::vector<double> thickness;
  if (!surface.triangles.empty())
  {
    if (auto error = FindLimits(surface, options, report))
    {
      return *error;
    }
    report.materials = MaterialsOf(surface);
    std::vector<double> raw;
    thickness = MeasureAll(surface, options, report, raw, monitor);
    if (monitor.Cancelled())
    {
      return Cancelled();
    }
    report.clippedAbove =
      std::count_if(raw.begin(), raw.end(), [&](double value) { return value >= report.maximum; });
    monitor.Progress(0.9, "Limiting the slope of the feature size");
    size = Govern(surface, options, thickness, report, monitor);
  }
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  surface.sizedMaterials = report.materials;
  surface.thickness = std::move(thickness);
  surface.targetEdgeLength.resize(size.size());
  std::transform(size.begin(), size.end(), surface.targetEdgeLength.begin(),
                 [&](double value) { return options.anisotropy / options.layers * value; });
  surface.featureSize = std::move(size);
  monitor.Progress(1, "Feature size known");
  return report;
}

} // namespace lamina
