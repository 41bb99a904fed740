// SPDX-License-Identifier: BSD-3-Clause
// The inner work of GrowColumns(): directions, heights, and their mending until all cells are sound.
#pragma once

#include "Columns.h"
#include "FrontCheck.h"

#include <functional>

namespace lamina
{

/// Two unit vectors that make a right-handed frame with the unit vector n.
std::array<Vec3, 2> FrameOf(const Vec3& n);

class ColumnGrowth
{
public:
  ColumnGrowth(const Wall& wall, const ColumnOptions& options, Monitor& monitor)
    : W(wall)
    , Options(options)
    , Watch(monitor)
  {
  }
  Result<Columns> Run();

private:
  void SetFractions();
  /// Shrink columns, and stop them at last, until all is sound. False: it did not come to an end.
  bool Mend(Monitor& watch);
  /// Stop columns until no prism is left that should be better; false: mending did not come to an end.
  bool StopPoor(Monitor& watch);
  /// For each triangle whose prisms are not what they must be the column that allows least.
  std::vector<Id> PoorlyStanding() const;
  /// Change columns (the change tells how many) and mend what is not sound then; undone where that costs a
  /// column.
  void Try(const std::function<Id()>& change, Monitor& watch);
  /// Freezes the columns that stopped since or bear poor prisms, and those near them; false if there are
  /// none.
  bool FreezeLost(const Columns& before);

  // Directions (ColumnDirections.cxx).
  void FindDirections();
  void FindDirection(Id v);
  double GroundAt(Id triangle, Id v) const;
  void SmoothDirections();
  /// The part of a vector that the column at v may have: in the plane of a cap on its rim.
  Vec3 Allowed(Id v, const Vec3& vector) const;
  /// The least quality that prisms at v can reach along this direction, however low.
  double Sight(Id v, const Vec3& direction) const;

  // Heights (ColumnHeights.cxx).
  void SetHeights();
  void SetHeight(Id v, double thickness);
  double TallestColumn(Id v) const;
  double LeastColumn(Id v) const;
  double RoomBeforeCaps(Id v) const;
  bool IsFollowedWell(Id triangle) const;
  void LowerLargePrisms();
  /// Limit the slope of heights round the columns in Lowered.
  void LimitSlopes();
  void Shrink(Id v, double factor);
  void Stop(Id v);

  // Cells and fronts (ColumnMending.cxx).
  bool IsSound(Id triangle) const;
  double AllowedOn(Id triangle) const;
  void AddTall(Id triangle, std::vector<Id>& nodes) const;
  Id MendCells(int round);
  double GapWish(Id v, double edge) const;
  Id MendFronts(FrontCheck& front, int round);
  std::vector<Vec3> FrontPoints() const;

  // Tops moved to where the cells are best (ColumnFairing.cxx).
  /// Move the tops of columns beside cells below `target` to where the worst cell around is best; never
  /// higher. Returns how often one moved.
  Id FairColumns(double target);
  /// The columns of triangles with a cell below `target`.
  std::vector<Id> PoorColumns(double target);
  /// Takes out of `nodes` some of which no two share a triangle.
  std::vector<Id> TakeApart(std::vector<Id>& nodes) const;
  bool ImproveColumn(Id v, double target);
  void PlaceTop(Id v, const Vec3& offset);
  /// The least quality of the cells on a triangle, or around a node; at most `enough`. Once it is known to be
  /// no more than `atLeast` the rest is not looked at.
  double WorstOf(Id triangle, double enough) const;
  double WorstAround(Id v, double atLeast, double enough) const;

  // Tops moved along the front to where its triangles are best (ColumnSmoothing.cxx).
  double FrontEnergy(Id v, const Vec3& offset) const;
  Vec3 FrontStep(Id v, const Vec3& offset, const std::array<Vec3, 2>& frame, double edge) const;
  bool SmoothTop(Id v);
  /// Lowers the front's energy near prisms that could be better; returns how often a top moved.
  Id SmoothFront();

  static constexpr int MostRounds = 120;
  /// Fronts should be this much of an edge apart, for the core between them to be well shaped.
  static constexpr double GapOfEdge = 0.3;
  /// A direction must allow this much more than the quality asked for, for prisms of some height to have it.
  static constexpr double RoomAbove = 1.03;
  double WallEdge(Id v) const { return this->Edge[static_cast<std::size_t>(v)]; }

  const Wall& W;
  const ColumnOptions& Options;
  Monitor& Watch;
  Columns C;
  std::vector<Vec3> Normals;    ///< of triangles
  std::vector<double> Seen;     ///< Sight() along the column
  std::vector<char> MustBeGood; ///< columns that stop rather than bear prisms below the quality asked for
  std::vector<double> Edge;     ///< mean length of the wall's edges at a node
  /// Clearance of the wall's triangles around a node, as far as layers could care.
  std::vector<double> WallGap;
  std::vector<char> Frozen; ///< columns that fairing leaves alone
  std::vector<char> Dirty;  ///< triangles to test (again)
  std::vector<Id> Lowered;  ///< columns that became lower since slopes were limited
};

} // namespace lamina
