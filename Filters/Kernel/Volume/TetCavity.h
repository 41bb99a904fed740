// SPDX-License-Identifier: BSD-3-Clause
// The operations on single tetrahedra that ImproveTets is made of.
#pragma once

#include "ChangeClock.h"
#include "ImproveTets.h"

#include <functional>

namespace lamina
{

/// What improvement strives for: the lesser of 3r/R and the least sine of a dihedral angle times a factor
/// that makes 8 degrees count as much as 3r/R of 0.2.
double ShapeOfTet(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The same, and its fit to the prisms behind.
double WorthOfTet(const TetSet& set, const std::array<Id, 4>& tet);

/// Takes out the tets that operations left behind (first node -1).
void DropReplaced(TetSet& set);

/// How bad a face between two cells with these centres is: the greater of its non-orthogonality over 85
/// degrees and its skewness over 4.
double FaceExcess(const std::array<Vec3, 3>& face, const Vec3& near, const Vec3& far);

/// The score of a place; whatever is no more than the second argument will do instead if it is no more.
using PlaceScore = std::function<double(const Vec3&, double)>;
/// From `start` uphill to where the score is best near it, with steps of `step` at first; score() is never
/// called last with the answer.
Vec3 SearchBest(const Vec3& start, double step, const PlaceScore& score);

/// The surroundings of some tets of a set, open to reconnection. Tets taken out keep their place with -1 as
/// first node, new ones are appended.
class TetCavity
{
public:
  using Tet = std::array<Id, 4>;
  enum class Done
  {
    Nothing,
    EdgeRemoved,
    FaceFlipped,
    CavityFilled,
    PointRemoved,
    PointAdded
  };

  /// Only the points of the tets `around` get their tets known.
  TetCavity(TetSet& set, const std::vector<Id>& around, ChangeClock* clock = nullptr);

  /// See WorthOfTet().
  double Quality(const Tet& tet) const;
  /// The best of removing one of the tet's edges or flipping one of its faces, if that raises the least
  /// quality.
  Done Reconnect(Id tet);
  /// Fills a cavity of some tets round it anew, in the best way that there is, if that raises the least
  /// quality. Free points of no layer may be left out.
  Done Refill(Id tet);
  /// Moves the tet's free points uphill; the number that moved.
  Id MovePoints(Id tet);
  /// Draws one of the tet's free points into another of its points, or puts a point into a cavity round it,
  /// if that raises the least quality. Points of layers are drawn into points of their own layer only, unless
  /// `acrossLayers`; `taken` gets them then.
  Done Collapse(Id tet, bool acrossLayers, std::vector<Id>& taken);
  Done Insert(Id tet);
  bool IsKnown(Id point) const;
  /// From here on `points` gets the points of all tets that operations look at beyond the stars of their
  /// tet's own points; null: no longer.
  void Watch(std::vector<Id>* points) { this->Watched = points; }
  /// The worst of the tet's faces towards others of its group and the prisms behind (FaceExcess()).
  double WorstFace(Id tet) const;
  /// Moves a free point of the tet, or flips or removes what is at its faces, if that lowers the worst face
  /// of all that is touched and no tet becomes worse than it was or `enough`. False: nothing could be done.
  bool BetterFaces(Id tet, double enough);

private:
  /// Tets to take out, those to put in, and the least quality of the new ones.
  struct Change
  {
    std::vector<Id> out;
    std::vector<Tet> in;
    double quality = -1;
    Done kind = Done::Nothing;
    Vec3 place; ///< of the point that an insertion adds
  };
  /// The faces of a set of tets towards the rest, counter-clockwise seen from outside.
  struct Shell;
  bool FindCavity(Id tet, const Vec3& place, Shell& shell) const;
  /// Of the tet that joins a shell's face to a new point.
  double QualityFrom(const Triangle& face, const Vec3& place) const;
  bool KeepsPoints(const Shell& shell) const;
  Id Next(const Shell& shell, const std::vector<Id>& points) const;
  Change Filled(const Shell& shell, const std::vector<Id>& points) const;
  std::vector<Vec3> PlacesIn(Id tet) const;
  Id Across(const Triangle& face, Id tet) const;
  bool MayRemove(Id point, Id into, bool acrossLayers) const;
  int LayerOf(Id point) const
  {
    return this->Set.layerIndex.empty() ? -1 : this->Set.layerIndex[static_cast<std::size_t>(point)];
  }
  /// Changes that raise the least quality above that of `best` are taken for it; new tets may be as poor as
  /// `enough` in any case.
  void RemoveEdge(Id tet, Id a, Id b, Change& best, double enough = 1) const;
  void FlipFace(Id tet, std::size_t opposite, Change& best, double enough = 1) const;
  /// The worst face of tets that stand, or would stand, in the place of some.
  double WorstOf(const std::vector<Tet>& tets, const std::vector<Id>& instead) const;
  double ExcessOf(const Tet& tet, std::size_t opposite, const std::vector<Tet>& tets,
                  const std::vector<Id>& instead) const;
  std::vector<Tet> CornersOf(const std::vector<Id>& tets) const;
  bool MoveForFaces(Id point, double enough);
  /// The best tets instead of a ring of them round edge (a, b), and their least quality; none if not above
  /// `floor`.
  double Triangulate(const std::vector<Id>& ring, Id a, Id b, double floor, std::vector<Tet>& in) const;
  bool FindRing(Id a, Id b, int group, std::vector<Id>& out, std::vector<Id>& ring) const;
  bool IsInterior(Id point) const;
  bool MovePoint(Id point);
  bool Allows(Id a, Id b) const;
  const std::vector<Id>& TetsOf(Id point) const;
  double LeastOf(const std::vector<Id>& tets) const;
  /// The same, but any value up to `enough` if it is no more. The tet that decides comes to the front, as it
  /// will often decide again.
  double LeastOf(std::vector<Id>& tets, double enough) const;
  bool IsSound(const std::vector<Tet>& tets) const;
  void Apply(const Change& change);

  TetSet& Set;
  ChangeClock* Clock;
  std::vector<Id>* Watched = nullptr;
  std::vector<Id> Slot; ///< one a point: where its tets stand in Stars, -1 unknown
  std::vector<std::vector<Id>> Stars;
};

} // namespace lamina
