// SPDX-License-Identifier: BSD-3-Clause
#include "SizeLimits.h"

#include "../Mesh/Adjacency.h"

#include <algorithm>
#include <sstream>

namespace lamina
{
namespace
{

std::string Text(double value)
{
  std::ostringstream out;
  out.precision(6);
  out << value;
  return out.str();
}

std::optional<Error> OutOfRange(const std::string& option, double value, const char* range)
{
  return InvalidOption(option + " is " + Text(value) + ", but must be " + range);
}

// Written so that NaN fails.
bool IsLength(double value)
{
  return value >= 0 && std::isfinite(value);
}

bool IsPositive(double value)
{
  return value > 0 && std::isfinite(value);
}

std::optional<Error> CheckMaterial(const FeatureSizeOptions& options, const MaterialSizing& own)
{
  const std::string of = " of material " + std::to_string(own.material);
  if (own.material < 1)
  {
    return InvalidOption("sizes are asked for material " + std::to_string(own.material) +
                         ", but materials are numbered from 1 (0 is background)");
  }
  if (std::count_if(options.materials.begin(), options.materials.end(),
                    [&](const MaterialSizing& m) { return m.material == own.material; }) > 1)
  {
    return InvalidOption("the sizes" + of + " are given twice: leave one out");
  }
  if (own.layers < 0)
  {
    return OutOfRange("layers" + of, own.layers, "1 or more, or 0 (as for all)");
  }
  if (!IsLength(own.anisotropy))
  {
    return OutOfRange("anisotropy" + of, own.anisotropy, "above 0, or 0 (as for all)");
  }
  if (!IsLength(own.minimum))
  {
    return OutOfRange("minimum" + of, own.minimum, "a length, or 0 (as for all)");
  }
  if (!IsLength(own.maximum))
  {
    return OutOfRange("maximum" + of, own.maximum, "a length, or 0 (as for all)");
  }
  return std::nullopt;
}

std::optional<Error> CheckOrder(double minimum, double maximum, const std::string& of, double edge)
{
  if (minimum <= maximum)
  {
    return std::nullopt;
  }
  return InvalidOption("the least feature size" + of + " (" + Text(minimum) + ") is above the largest (" +
                       Text(maximum) +
                       "): lower the first or raise the second; 0 takes 2.6 and 20 mean edge "
                       "lengths of " +
                       Text(edge));
}

/// Materials that have sizes of their own must be there.
std::optional<Error> CheckPresent(const FeatureSizeOptions& options, const std::vector<int>& present)
{
  for (const MaterialSizing& own : options.materials)
  {
    if (!std::binary_search(present.begin(), present.end(), own.material))
    {
      std::string list;
      for (int material : present)
      {
        list += (list.empty() ? "" : ", ") + std::to_string(material);
      }
      return InvalidOption("sizes are asked for material " + std::to_string(own.material) +
                           ", which the surface lacks; it has " + list);
    }
  }
  return std::nullopt;
}

} // namespace

std::optional<Error> CheckOptions(const FeatureSizeOptions& o)
{
  if (!IsLength(o.minimum))
  {
    return OutOfRange("minimum", o.minimum, "a length of 0 (automatic) or more");
  }
  if (!IsLength(o.maximum))
  {
    return OutOfRange("maximum", o.maximum, "a length of 0 (automatic) or more");
  }
  if (!IsPositive(o.gradient))
  {
    return OutOfRange("gradient", o.gradient, "above 0");
  }
  if (o.layers < 1)
  {
    return OutOfRange("layers", o.layers, "1 or more");
  }
  if (!IsPositive(o.anisotropy))
  {
    return OutOfRange("anisotropy", o.anisotropy, "above 0");
  }
  if (!(o.coneAngle >= 0 && o.coneAngle <= 60))
  {
    return OutOfRange("coneAngle", o.coneAngle, "in [0, 60] degrees");
  }
  if (o.nodesPerCircumference != 0 && o.nodesPerCircumference < 3)
  {
    return OutOfRange("nodesPerCircumference", o.nodesPerCircumference, "3 or more, or 0 (any)");
  }
  if (!IsPositive(o.edgePerLayer))
  {
    return OutOfRange("edgePerLayer", o.edgePerLayer, "above 0");
  }
  for (const MaterialSizing& own : o.materials)
  {
    if (auto error = CheckMaterial(o, own))
    {
      return error;
    }
  }
  return std::nullopt;
}

Result<std::vector<SizeLimits>> FindLimits(const TriangleComplex& surface, const FeatureSizeOptions& options,
                                           FeatureSizeReport& report)
{
  const double edge = MeanEdgeLength(surface);
  if (!(edge > 0))
  {
    return InvalidInput("all points of the surface coincide", { surface.points.front() });
  }
  report.minimum = options.minimum > 0 ? options.minimum : 2.6 * edge;
  report.maximum = options.maximum > 0 ? options.maximum : 20 * edge;
  report.materials = MaterialsOf(surface);
  auto error = CheckOrder(report.minimum, report.maximum, "", edge);
  error = error ? error : CheckPresent(options, report.materials);
  if (error)
  {
    return *error;
  }
  std::vector<SizeLimits> limits;
  for (int material : report.materials)
  {
    limits.push_back({ material, options.layers, options.anisotropy, report.minimum, report.maximum });
    SizeLimits& l = limits.back();
    for (const MaterialSizing& own : options.materials)
    {
      if (own.material == material)
      {
        l.layers = own.layers > 0 ? own.layers : l.layers;
        l.anisotropy = own.anisotropy > 0 ? own.anisotropy : l.anisotropy;
        l.minimum = own.minimum > 0 ? own.minimum : l.minimum;
        l.maximum = own.maximum > 0 ? own.maximum : l.maximum;
      }
    }
    if ((error = CheckOrder(l.minimum, l.maximum, " of material " + std::to_string(material), edge)))
    {
      return *error;
    }
  }
  return limits;
}

} // namespace lamina
