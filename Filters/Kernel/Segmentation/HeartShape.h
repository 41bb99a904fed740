// SPDX-License-Identifier: BSD-3-Clause
// The phantom heart as signed distances: chambers, walls, valves, strands, coronary trees.
#pragma once

#include "../Base/Types.h"

#include <vector>

namespace lamina
{

/// A rod with round ends whose radius changes linearly from end to end.
struct TaperedRod
{
  Vec3 from;
  Vec3 to;
  double fromRadius = 1;
  double toRadius = 1;
  int bloodComponent = 0; ///< coronaries: which tree
};

/// What a point of the heart belongs to.
enum class HeartPart : unsigned char
{
  Outside = 0,
  Wall = 1,    ///< tissue: walls, septa, papillary muscles' roots
  Leaflet = 2, ///< tissue: of a valve
  Strand = 3,  ///< tissue: papillary muscle, chorda or tendon, free in the blood
  Chamber = 4, ///< blood: chambers and great vessels
  Coronary = 5 ///< blood
};

/// Signed distances, negative inside, about metric near the surfaces (heart units: 1/112 of the heart's
/// length).
struct HeartSample
{
  double heart = 0; ///< to the outside of the whole heart
  double blood = 0; ///< to the blood of chambers, vessels and coronaries
  HeartPart part = HeartPart::Outside;
};

/// What a heart is made of; each level has all of the one before.
enum class HeartLevel
{
  Single,     ///< one ventricle
  Ventricles, ///< two
  Chambers,   ///< atria and great vessels too
  Whole       ///< valves, papillary muscles, strands and coronaries too
};

/// How finely the image will show the shape decides what can be part of it: every structure is at least about
/// two voxels thick, walls between two bloods four, and what would not fit is left out.
class HeartShape
{
public:
  /// voxel: the edge length of a voxel in heart units; open: great vessels go on without end upwards.
  HeartShape(double voxel, HeartLevel level, bool open);

  /// The rods near a ball: what Sample() must look at for points inside it.
  struct Nearby
  {
    std::vector<TaperedRod> coronaries;
    std::vector<TaperedRod> strands;
  };
  Nearby Near(const Vec3& centre, double radius) const;
  HeartSample Sample(const Vec3& point, const Nearby& nearby) const;

  /// The corners of a box around the whole heart (open vessels count up to where they would be closed).
  void Bounds(Vec3& least, Vec3& greatest) const;
  const std::vector<TaperedRod>& GetCoronaries() const { return this->Coronaries; }
  const std::vector<TaperedRod>& GetStrands() const { return this->Strands; }
  /// The number of bodies of blood that the shape is made of.
  int BloodComponents() const
  {
    return this->Level == HeartLevel::Single ? 1 : (this->Coronaries.empty() ? 2 : 4);
  }

private:
  /// Blood of the left and right heart without what hangs in it, and the outside of the walls around both.
  struct Chambers
  {
    double left = 0;
    double right = 0;
    double heart = 0;
  };
  Chambers SampleChambers(const Vec3& p) const;
  void SampleLeft(const Vec3& p, Chambers& out) const;
  void SampleRight(const Vec3& p, Chambers& out) const;
  double SampleLeaflets(const Vec3& p) const;
  double AtLeast(double length, double voxels) const;
  void AddStrands();
  void AddCoronaries();
  void AddVessel(const std::vector<Vec3>& path, double fromRadius, double toRadius, double depth, int tree);

  double Voxel;
  HeartLevel Level;
  bool Open;
  std::vector<TaperedRod> Coronaries;
  std::vector<TaperedRod> Strands;
};

} // namespace lamina
