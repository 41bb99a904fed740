// SPDX-License-Identifier: BSD-3-Clause
// The surface as it entered refinement: what edits are measured against, and where fields are read.
#pragma once

#include "../Mesh/JunctionGraph.h"
#include "../Mesh/VolumeCorrection.h"
#include "../Search/TriangleTree.h"
#include "StretchField.h"

#include <memory>

namespace lamina
{

/// A tree over the triangles of each sheet.
using SheetTrees = std::vector<std::unique_ptr<TriangleTree>>;
SheetTrees MakeSheetTrees(const TriangleComplex& surface, const SheetGraph& sheets);

class InputSurface
{
public:
  /// `tolerance`: largest distance of edits, a length; 0: the smaller of a tenth of the local feature size (a
  /// fifth of the target where there is no feature size) and half a mean edge, which is less than half a
  /// voxel.
  /// `anisotropy`: how much longer edges may be along the least curvature.
  /// `share`: what edits may use of the tolerance; the rest is for what lies between the places that are
  /// looked at, and for what corrects volumes after them.
  InputSurface(const TriangleComplex& surface, double tolerance, double anisotropy, Monitor& monitor,
               double share = 0.75);

  const TriangleComplex& Surface() const { return this->Complex; }
  const SheetGraph& Sheets() const { return this->Graph; }
  double MeanEdge() const { return this->Mean; }
  /// The closest point of a sheet within `limit`; triangle -1 if there is none.
  TriangleTree::Closest ClosestOnSheet(int sheet, const Vec3& p, double limit) const;
  /// True if p lies within the tolerance (times `scale`) of the sheet. `hint`: a triangle to look at first,
  /// or -1; becomes the one that was found.
  bool IsNear(int sheet, const Vec3& p, Id& hint, double scale = 1) const;
  /// The triangles of a sheet within a distance of p, ascending.
  std::vector<Id> TrianglesNear(int sheet, const Vec3& p, double distance) const;
  /// The tolerance at a place.
  double Tolerance(const TriangleTree::Closest& place) const;
  /// What the tolerance of edits is times this is all that there is.
  double WholeOverShare() const { return 1 / this->Share; }
  /// The largest tolerance.
  double WidestTolerance() const { return this->Widest; }
  /// The tolerance at a point of the input.
  double Tolerance(Id point) const { return this->Tolerances[static_cast<std::size_t>(point)]; }
  /// From now on edits must keep triangles that face each other apart.
  void KeepGaps();
  bool KeepsGaps() const { return this->WidestGap > 0; }
  /// As far as this, or ShareOfGap of what lay between their places in the input if that is less: somewhat
  /// more than a quarter of a voxel, of which the mean edge tells the size, or of the target if that is less.
  /// Around a single material there may never have been voxels: there the target alone counts. 0 without
  /// KeepGaps().
  double LeastGap(double target) const;
  static constexpr double ShareOfGap = 0.53; ///< half of it is promised; the rest is for correcting volumes
  /// The place of a sheet nearest to p.
  Vec3 Origin(int sheet, const Vec3& p) const;
  double TargetAt(const TriangleTree::Closest& place) const
  {
    return this->Interpolate(this->Complex.targetEdgeLength, place);
  }
  /// A field of axes, which point either way, at a place.
  Vec3 InterpolateAxis(const std::vector<Vec3>& field, const TriangleTree::Closest& place) const;
  Stretch StretchAt(const TriangleTree::Closest& place) const
  {
    return this->InterpolateAxis(this->PointStretches, place);
  }
  /// One a point, or none if all edges are to be alike.
  const std::vector<Stretch>& Stretches() const { return this->PointStretches; }
  /// A point field at a place; NaN corners are left out.
  double Interpolate(const std::vector<double>& field, const TriangleTree::Closest& place,
                     std::size_t stride = 1, std::size_t component = 0) const;
  int TriangleSheet(Id t) const { return this->Graph.sheetOfTriangle[static_cast<std::size_t>(t)]; }

private:
  bool IsWithin(const TriangleTree::Closest& place, double scale) const;

  TriangleComplex Complex;
  SheetGraph Graph;
  double Mean;
  double Widest; ///< the largest tolerance
  double Share;
  double WidestGap = 0; ///< between triangles that face each other
  std::vector<double> Tolerances;
  std::vector<Stretch> PointStretches;
  SheetTrees Trees;
};

} // namespace lamina
