// SPDX-License-Identifier: BSD-3-Clause
// A multimaterial surface whose triangles can be split, merged and swapped. Every edit keeps the topology of
// the complex, and is refused where it would fold, intersect, hide a node or leave the input surface.
#pragma once

#include "../Base/ShortList.h"
#include "../Mesh/VolumeCorrection.h"
#include "SurfaceEdit.h"
#include "TriangleGrid.h"

namespace lamina
{

/// The triangles at an edge: two, or as many as sheets meet there.
using EdgeTriangles = ShortList<Id, 6>;

/// How many edits were done, of whatever purpose.
struct EditCounts
{
  Id splits = 0;
  Id merges = 0;
  Id swaps = 0;
};

class EditableSurface
{
public:
  /// `input` is the surface that edits must stay near to; it outlives this object.
  EditableSurface(const InputSurface& input, double mergeRatio, double splitRatio);

  // What is there. Ids of removed points and triangles stay unused.
  Id PointCount() const { return static_cast<Id>(this->Points.size()); }
  const Vec3& Point(Id p) const { return this->Points[static_cast<std::size_t>(p)]; }
  double Target(Id p) const { return this->Targets[static_cast<std::size_t>(p)]; }
  bool IsAlive(Id triangle) const { return this->Triangles[static_cast<std::size_t>(triangle)][0] >= 0; }
  Id TriangleCount() const { return static_cast<Id>(this->Triangles.size()); }
  const Triangle& Corners(Id triangle) const { return this->Triangles[static_cast<std::size_t>(triangle)]; }
  const std::vector<Id>& Star(Id p) const { return this->Stars[static_cast<std::size_t>(p)]; }
  /// The length of an edge, in the metric of the stretches.
  double Length(Id a, Id b) const
  {
    const Vec3 edge = this->Point(a) - this->Point(b);
    return this->Stretches.empty()
             ? Norm(edge)
             : std::sqrt(StretchedLength2(edge, this->Stretches[static_cast<std::size_t>(a)],
                                          this->Stretches[static_cast<std::size_t>(b)]));
  }
  const EditCounts& Counts() const { return this->Done; }
  /// Length over the stricter target of the two ends.
  double RelativeLength(Id a, Id b) const
  {
    return this->Length(a, b) / std::min(this->Target(a), this->Target(b));
  }
  /// 2 r/R in the metric of the stretches.
  double Quality(Id triangle) const { return this->Quality(this->Corners(triangle)); }
  /// The triangles at edge (a, b).
  EdgeTriangles TrianglesAt(Id a, Id b) const;
  /// A count of the changes so far, and its value when a triangle last changed or one of its points moved.
  Id Clock() const { return this->Changes; }
  Id ChangedAt(Id triangle) const { return this->Changed[static_cast<std::size_t>(triangle)]; }
  /// The same for anything at p or a point that it shares a triangle with.
  Id ChangedAround(Id p) const;

  /// The least quality of the triangles that a bisection of the edge would make.
  double QualityOfHalves(Id a, Id b) const;

  // Edits; each returns whether it was done.
  /// What the edits at an edge, or at the point a, look at and change.
  EditRegion RegionOf(Id a, Id b = -1) const;
  /// Bisect the edge at its middle; always safe. Returns the new point.
  Id Split(Id a, Id b);
  /// Carry out what was planned, if it is sound.
  bool CarryOut(const EditPlan& plan);
  /// Merge the two ends of an edge; `anyLength` allows new edges longer than the targets (to remove a bad
  /// triangle).
  bool Merge(Id a, Id b, bool anyLength = false);
  /// The same, to be carried out later. Edits in regions that are apart may be planned at the same time in
  /// several threads: while one is planned the point that it moves is elsewhere.
  void PlanMerge(Id a, Id b, bool anyLength, EditPlan& plan);
  /// Swap the edge for the other diagonal of its two triangles if that betters the worse of the two.
  bool Swap(Id a, Id b);
  /// Move the point towards evenly sized triangles without a change of volume.
  bool Relax(Id p);
  /// Whether anything around p changed since that was last tried in vain.
  bool MayRelax(Id p) const;
  void PlanRelax(Id p, EditPlan& plan);
  /// Move a point of a sheet anywhere near without a change of volume, or one of a curve along it, where that
  /// betters the worst of its triangles.
  bool Reshape(Id p);
  /// Bisect the longest edge of a flat triangle if the halves of all triangles there are much better than the
  /// worst of these.
  bool SplitFlat(Id triangle);

  /// Where no direction sees all faces of p well (cosine below 0.5), one edit that betters this: a move,
  /// merge or swap. Here faces may turn. `gain`: the share of what blocks the sight that it must take away.
  bool Uncover(Id p, double gain);
  /// How well the best direction into the worst material at p sees the faces there: a cosine.
  double Visibility(Id p) const { return this->Visibility(p, nullptr); }

  /// Give all points and triangles new ids in an order of space, without gaps: neighbours then lie together
  /// in memory too.
  void Renumber();

  /// The result: points and triangles compacted, fields interpolated from the input.
  void Write(TriangleComplex& surface, Monitor& monitor) const;
  /// The stretches of the points as Write() puts them out, or none.
  std::vector<Stretch> WrittenStretches() const;
  /// The sheets of the triangles as Write() puts them out, with the shells of the input.
  SheetGraph WrittenSheets() const;

private:
  enum Class : unsigned char
  {
    OnSheet,
    OnCurve,
    AtCorner,
    Removed
  };
  using Edit = SurfaceEdit;
  using Added = SurfaceEdit::Added;

  double Quality(const Triangle& corners) const;
  bool IsFeature(const EdgeTriangles& triangles) const;
  bool LinkAllows(Id gone, Id kept, const EdgeTriangles& shared) const;
  Vec3 MergedPlace(Id gone, Id kept, const EdgeTriangles& shared) const;
  void PlanMergeInto(Id gone, Id kept, const EdgeTriangles& shared, const Vec3& place, bool anyLength,
                     EditPlan& plan);
  /// Make an edit that removes the stars of p and (if not negative) q.
  void RemoveStars(Edit& edit, Id p, Id q = -1) const;
  void RemoveTriangles(Edit& edit, const EdgeTriangles& triangles) const;
  void Add(Edit& edit, const Triangle& corners, Id replaced) const;
  bool TryMove(Id p, const Vec3& place, double leastQuality);
  void PlanMove(Id p, const Vec3& place, double leastQuality, EditPlan& plan);
  bool RelaxingMove(Id p, Vec3& move) const;
  bool TryAround(Id p, double length, double leastQuality, bool along);
  bool TryAlongCurve(Id p, double length, double leastQuality);
  Vec3 VolumeGradient(Id p) const;
  double WorstQuality(Id p) const;
  bool CurveNeighbours(Id p, Id& before, Id& after) const;

  void WriteFields(TriangleComplex& surface, const std::vector<int>& sheetOfPoint, Monitor& monitor) const;
  bool UncoverByMove(Id p);
  bool UncoverByMerge(Id p);
  bool UncoverBySwap(Id p);
  /// True if a triangle at p belongs to a plane patch.
  bool IsOnPatch(Id p) const;
  bool UncoverBySearch(Id p);
  std::vector<Id> RingOf(Id p) const;

  // Is the edit sound, with the coordinates that points have now?
  bool IsSound(Edit& edit) const;
  bool HasGoodShapes(Edit& edit) const;
  bool IsNearInput(Edit& edit) const;
  bool KeepsInputNear(Edit& edit) const;
  /// Fill the owners; the largest distance over tolerance of a sample, squared.
  double PlaceSamples(Edit& edit) const;
  bool IsClearOfOthers(const Edit& edit, bool allVisible) const;
  bool IsClearOfItself(const Edit& edit) const;
  bool StaysApart(const Added& added, Id other, double leastGap) const;
  bool OpensWide(const Edit& edit, bool allVisible) const;
  template<typename At>
  double GreatestCosine(const Triangle& corners, const std::vector<Triangle>& others, bool all,
                        At&& at) const;
  bool KeepsNodesVisible(const Edit& edit, bool& allVisible) const;
  double Visibility(Id p, const Edit* edit, double* blocked = nullptr) const;
  double SightAfter(Id p, const Edit& edit) const;

  Box BoxOf(const Triangle& t) const
  {
    Box box;
    for (Id p : t)
    {
      box.Add(this->Point(p));
    }
    return box;
  }
  /// Put the added triangles in and the removed ones out; `moved`, if not negative, comes to lie at `place`.
  void Commit(const Edit& edit, Id moved = -1, const Vec3& place = {});
  void Insert(Id id, const Triangle& corners, int sheet, const Vec3& normal, Id hint);
  void Remove(Id id);
  Id AddTriangle();

  /// How far a search for a better place of a point goes, in its target.
  static constexpr double searchSteps[] = { 0.25, 0.1, 0.04, 0.016 };
  static constexpr double goodSight = 0.5; ///< a node that sees this well needs no uncovering

  const InputSurface& Input;
  double MergeRatio;
  double SplitRatio;
  std::vector<Vec3> Points;
  std::vector<double> Targets;
  std::vector<Stretch> Stretches; ///< one a point, or none
  std::vector<Class> Classes;
  std::vector<std::vector<Id>> Stars;
  std::vector<Triangle> Triangles;
  std::vector<int> Sheets;   ///< sheet of a triangle, in the input's SheetGraph
  std::vector<Vec3> Normals; ///< unit normal of a triangle
  std::vector<Id> Hints;     ///< a triangle of the input near a triangle, or -1
  std::vector<Id> Changed;   ///< the clock when a triangle last changed
  std::vector<Id> Relaxed;   ///< the clock when a point was last tried to relax in vain
  InputSamples Samples;      ///< points of the input on the triangles nearest to them
  Id Changes = 0;
  EditCounts Done;
  std::vector<Id> NewIds;      ///< of the triangles that an edit adds
  EditPlan Work;               ///< the edit in hand, kept for its memory
  std::vector<Id> PairOfSheet; ///< a triangle of the input on each sheet, for its materials and patch
  TriangleGrid Grid;
  bool Mending = false;   ///< within Uncover
  Id Mended = -1;         ///< the point that is being uncovered
  double MostBlocked = 0; ///< of its sight after an edit
};

} // namespace lamina
