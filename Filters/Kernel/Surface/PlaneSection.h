// SPDX-License-Identifier: BSD-3-Clause
// What a plane cuts out of a surface: pieces of material, each with its rims.
#pragma once

#include "../Geometry/FlatTriangulation.h"
#include "../Mesh/TriangleComplex.h"

namespace lamina
{

/// A plane with coordinates in it; u, v and the normal are a right-handed frame of unit vectors.
struct PlaneFrame
{
  Vec3 origin;
  Vec3 normal;
  Vec3 u;
  Vec3 v;

  PlaneFrame(const Vec3& place, const Vec3& direction);
  double Height(const Vec3& p) const { return Dot(p - this->origin, this->normal); }
  Vec2 ToPlane(const Vec3& p) const
  {
    return { Dot(p - this->origin, this->u), Dot(p - this->origin, this->v) };
  }
  Vec3 ToSpace(const Vec2& p) const { return this->origin + this->u * p.x + this->v * p.y; }
};

/// The section of a closed surface by a plane that passes through none of its points.
class PlaneSection
{
public:
  PlaneSection(const TriangleComplex& surface, const PlaneFrame& frame, const std::vector<double>& heights);

  bool IsEmpty() const { return this->Segments.empty(); }
  /// The piece of a triangle that the plane crosses, else -1. Pieces are regions of material (any but
  /// background) that hang together in the plane; their rims and the borders inside them belong to them.
  int PieceOfTriangle(Id triangle) const { return this->PieceOf[static_cast<std::size_t>(triangle)]; }
  int PieceCount() const { return this->Count; }
  /// The triangles that the plane crosses in one piece.
  std::vector<Id> TrianglesOfPiece(int piece) const;

  struct Nearest
  {
    int piece = -1;
    double distance = 0; ///< 0 if the place lies in the piece
  };
  /// The piece that a place in the plane lies in, else the nearest one.
  Nearest Find(const Vec2& place) const;
  double AreaOfPiece(int piece) const;

private:
  struct Segment
  {
    Id triangle;
    Vec2 a;
    Vec2 b;
    Vec2 across; ///< towards the second material
    MaterialPair pair;
    std::size_t rim = 0;
  };
  struct Sight
  {
    std::size_t segment = 0;
    int label = 0; ///< background if nothing is hit
    bool hit = false;
  };
  /// What is seen from a place towards +x, segments of `rim` left out (-1: none is).
  Sight Look(const Vec2& from, Id rim) const;
  void JoinRims();

  std::vector<Segment> Segments;
  std::vector<int> PieceOf;
  std::vector<int> PieceOfRim;
  int Count = 0;
};

} // namespace lamina
