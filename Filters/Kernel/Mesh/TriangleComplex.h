// SPDX-License-Identifier: BSD-3-Clause
// The interface surface: points, triangles and the two materials each triangle parts. Non-manifold by design.
#pragma once

#include "../Base/Types.h"

#include <array>
#include <string>
#include <vector>

namespace lamina
{

/// The two materials of a triangle; its normal points from `first` to `second`.
/// Background (0) always stands second, else first < second (the convention of vtkSurfaceNets3D's
/// BoundaryLabels).
struct MaterialPair
{
  int first = 0;
  int second = 0;
};
inline bool operator==(const MaterialPair& a, const MaterialPair& b)
{
  return a.first == b.first && a.second == b.second;
}
inline bool operator!=(const MaterialPair& a, const MaterialPair& b)
{
  return !(a == b);
}
inline bool operator<(const MaterialPair& a, const MaterialPair& b)
{
  return a.first != b.first ? a.first < b.first : a.second < b.second;
}

/// Values of JunctionKind (house contract).
enum JunctionKind : unsigned char
{
  JunctionSheet = 0,
  JunctionCurve = 1,
  JunctionCorner = 2,
  JunctionInBorderPlane = 4 ///< added to the kind of a point that must stay in a border plane
};

/// Triangles between materials with shared points: junction curves are the edges where other than two
/// triangles, or triangles of different material pairs or patches, meet.
struct TriangleComplex
{
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  std::vector<MaterialPair> materials; ///< one a triangle
  std::vector<int> patches;            ///< one a triangle: 0 a wall, else an opening; empty means all 0
  std::vector<std::string> patchNames; ///< name of patch p at index p; may be empty

  /// Empty or one a triangle: the volume that its first and its second material have in the image and lack
  /// here, because the labels were repaired; in cubes of the square root of the triangle's area, so that it
  /// holds at any scale.
  std::vector<std::array<double, 2>> missing;

  // What travels with the points, each empty or one value a point.
  std::vector<unsigned char> junctionOrder; ///< number of materials that meet (background counts)
  std::vector<unsigned char> junctionKind;
  std::vector<double> featureSize;      ///< governing, clipped, gradient-limited
  std::vector<double> targetEdgeLength; ///< what refinement aims at
  std::vector<int> sizedMaterials;      ///< the materials of thickness' columns
  std::vector<double>
    thickness; ///< MaterialFeatureSize: points x sizedMaterials, row by row; NaN where not touched
  std::vector<double> layerHeight; ///< of the last layer behind the point of a front, a length
  std::vector<Vec3> layerSide;     ///< from the layer below to the point of a front; zero: no layer there
  std::vector<double> maximumCurvature; ///< principal curvatures, 1/length (see Sizing/Curvature.h)
  std::vector<double> minimumCurvature;
  std::vector<Vec3> maximumCurvatureDirection; ///< unit

  int Patch(Id triangle) const
  {
    return this->patches.empty() ? 0 : this->patches[static_cast<std::size_t>(triangle)];
  }
};

} // namespace lamina
