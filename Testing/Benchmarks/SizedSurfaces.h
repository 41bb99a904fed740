// SPDX-License-Identifier: BSD-3-Clause
// Surfaces for the programs that measure stages: read from files, and sized.
#pragma once

#include "Arguments.h"
#include "RefinementFiles.h"
#include "Sizing/FeatureSize.h"
#include "Surface/ExtractInterfaces.h"
#include "Surface/SmoothSurface.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace lamina::measures
{

inline bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

template<typename R>
void Demand(const R& result, const char* stage)
{
  if (!result)
  {
    std::printf("%s: %s\n", stage, result.GetError().message.c_str());
    std::exit(1);
  }
}

inline TriangleComplex FromLabels(std::ifstream& file, double& voxel, Monitor& monitor)
{
  LabelImage image;
  const auto size = Take<Id>(file, 3);
  const auto spacing = Take<double>(file, 3);
  image.grid.size = { { size[0], size[1], size[2] } };
  image.grid.spacing = { spacing[0], spacing[1], spacing[2] };
  image.labels = Take<int>(file, static_cast<std::size_t>(image.grid.Count()));
  voxel = std::min({ spacing[0], spacing[1], spacing[2] });
  TriangleComplex surface;
  Demand(ExtractInterfaces(image, surface, {}, monitor), "extract");
  Demand(SmoothSurface(surface, {}, monitor), "smooth");
  return surface;
}

/// Calls act(column) for everything that a sized surface holds.
template<typename Act>
void ForColumns(TriangleComplex& s, Act&& act)
{
  act(s.points);
  act(s.triangles);
  act(s.materials);
  act(s.patches);
  act(s.junctionKind);
  act(s.junctionOrder);
  act(s.featureSize);
  act(s.targetEdgeLength);
  act(s.sizedMaterials);
  act(s.thickness);
  act(s.maximumCurvature);
  act(s.minimumCurvature);
  act(s.maximumCurvatureDirection);
}

inline void Save(TriangleComplex& surface, double voxel, const std::string& path)
{
  std::ofstream file(path, std::ios::binary);
  const auto put = [&](const void* data, std::size_t bytes)
  { file.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes)); };
  put(&voxel, sizeof(voxel));
  ForColumns(surface,
             [&](const auto& column)
             {
               const Id count = static_cast<Id>(column.size());
               put(&count, sizeof(count));
               put(column.data(), column.size() * sizeof(column[0]));
             });
}

inline TriangleComplex Load(std::ifstream& file, double& voxel)
{
  TriangleComplex surface;
  voxel = Take<double>(file, 1)[0];
  ForColumns(surface,
             [&](auto& column)
             {
               using Value = typename std::decay_t<decltype(column)>::value_type;
               column = Take<Value>(file, static_cast<std::size_t>(Take<Id>(file, 1)[0]));
             });
  return surface;
}

/// The surface of a .labels or .surface file (WriteRefinementInputs.py) with feature sizes, or of a .sized
/// file, which has them. NAME=VALUE: layers, anisotropy, minimum, maximum.
inline TriangleComplex Sized(const std::string& path, const Arguments& arguments, double& voxel,
                             Monitor& monitor)
{
  std::ifstream file(path, std::ios::binary);
  if (EndsWith(path, ".sized"))
  {
    return Load(file, voxel);
  }
  TriangleComplex surface =
    EndsWith(path, ".labels") ? FromLabels(file, voxel, monitor) : FromTriangles(file);
  FeatureSizeOptions sizing;
  sizing.layers = static_cast<int>(arguments.Get("layers", sizing.layers));
  sizing.anisotropy = arguments.Get("anisotropy", sizing.anisotropy);
  sizing.edgePerLayer = std::max(sizing.edgePerLayer, sizing.anisotropy);
  sizing.minimum = arguments.Get("minimum", 0);
  sizing.maximum = arguments.Get("maximum", 0);
  Demand(ComputeFeatureSize(surface, sizing, monitor), "size");
  return surface;
}

} // namespace lamina::measures
