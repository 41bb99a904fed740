// SPDX-License-Identifier: BSD-3-Clause
// Which moves of points are safe: nothing folds, nothing comes near, nobody strays from the image.
#pragma once

#include "../Base/Monitor.h"
#include "EdgeRelaxation.h"

namespace lamina
{

/// How far points may end from where they were before all sweeps.
struct DriftCaps
{
  double alongNormal = 0; ///< along the surface's normal there
  double inAll = 0;
};

/// Accepts or refuses relaxations during one phase of sweeps. Safety rests on two bounds: every point stays
/// within a ball around its place at the phase's start, small enough that triangles without a common corner
/// cannot meet; and triangles with a common corner keep their direction, shape and dihedral angles.
class MoveGuard
{
public:
  MoveGuard(const SmoothingState& state, const DriftCaps& caps);

  /// Begin a phase at the present positions with the given ball radii.
  void StartPhase(std::vector<double> radii);
  bool Allows(const Relaxation& relaxation) const;
  /// Whether `place` lies where point p may be in this phase.
  bool StaysNear(Id p, const Vec3& place) const;
  /// Whether a triangle keeps direction and shape where its points are now.
  bool KeepsTriangle(Id t) const;
  /// The points, ascending, that a step of many points from `before` to where they are now must not move so
  /// far: they left their bounds, or belong to a triangle or an edge that turned or closed too much.
  std::vector<Id> Offending(const std::vector<Vec3>& before, Monitor& monitor) const;
  /// Whether the angles at a triangle's edges must be watched: no step may move its points unseen.
  bool IsSharp(Id t) const { return this->Sharp[static_cast<std::size_t>(t)] != 0; }
  const std::vector<Vec3>& PhaseStart() const { return this->Anchor; }
  /// The positions before all sweeps; nothing can be asked of the guard after it.
  std::vector<Vec3> TakeOrigin() { return std::move(this->Origin); }
  const std::vector<Vec3>& BeforeAll() const { return this->Origin; }

private:
  bool OpensWide(Id edge) const;
  bool Closes(const Edge& edge, const std::vector<Vec3>& before) const;
  bool Keeps(Id t, const Vec3& a, const Vec3& b, const Vec3& c) const;
  Vec3 Place(Id p, const Relaxation& r) const;
  bool KeepsTriangles(Id p, const Relaxation& r, double& growth) const;
  bool KeepsAngles(Id t, const Relaxation& r) const;

  const SmoothingState& State;
  DriftCaps Caps;
  std::vector<Vec3> Origin;       ///< positions before all sweeps
  std::vector<Vec3> OriginNormal; ///< unit normals there
  std::vector<Vec3> Anchor;
  std::vector<Vec3> AnchorNormal; ///< of triangles
  std::vector<char> Sharp;        ///< triangles with an edge that needs its angle watched in this phase
  std::vector<double> Radii;
};

} // namespace lamina
