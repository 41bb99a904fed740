// SPDX-License-Identifier: BSD-3-Clause
#include "SheetStencil.h"

#include <algorithm>

namespace lamina
{
namespace
{

constexpr Id Grain = 4096;
/// A neighbourhood of three edge lengths has about 60 triangles; more than this only where triangles are
/// very uneven, and then the nearest ones in edges do.
constexpr std::size_t MostTriangles = 400;
constexpr std::size_t TableSize = 1024; // a power of two, at least twice as large as what enters it
constexpr int TableBits = 10;

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

bool HasCorner(const Triangle& t, Id point)
{
  return t[0] == point || t[1] == point || t[2] == point;
}

/// The one other triangle at the edge (a, b) that goes on in the sheet of `t`; -1 if there is none.
Id Across(const TriangleComplex& surface, const Lists& star, Id t, Id a, Id b)
{
  Id other = -1;
  for (Id s : Row(star, a))
  {
    if (s != t && HasCorner(surface.triangles[U(s)], b))
    {
      if (other >= 0)
      {
        return -1;
      }
      other = s;
    }
  }
  const bool goesOn = other >= 0 && surface.materials[U(other)] == surface.materials[U(t)] &&
                      surface.Patch(other) == surface.Patch(t);
  return goesOn ? other : -1;
}

} // namespace

SheetNeighbours FindSheetNeighbours(const TriangleComplex& surface, const Lists& star, Monitor& monitor)
{
  SheetNeighbours neighbours(surface.triangles.size());
  monitor.For(static_cast<Id>(neighbours.size()), Grain,
              [&](Id begin, Id end)
              {
                for (Id t = begin; t < end; ++t)
                {
                  const Triangle& c = surface.triangles[U(t)];
                  for (std::size_t k = 0; k < 3; ++k)
                  {
                    neighbours[U(t)][k] = Across(surface, star, t, c[k], c[(k + 1) % 3]);
                  }
                }
              });
  return neighbours;
}

SheetStencil::Numbering::Numbering()
  : table(TableSize, -1)
{
  this->ids.reserve(MostTriangles);
}

std::size_t SheetStencil::Numbering::Slot(Id id) const
{
  // Neighbouring ids are spread by Knuth's multiplicative hash.
  std::size_t slot = (static_cast<std::size_t>(id) * 0x9E3779B97F4A7C15ULL) >> (64 - TableBits);
  while (this->table[slot] >= 0 && this->ids[U(this->table[slot])] != id)
  {
    slot = (slot + 1) % TableSize;
  }
  return slot;
}

Id SheetStencil::Numbering::Find(Id id) const
{
  return this->table[this->Slot(id)];
}

Id SheetStencil::Numbering::Add(Id id)
{
  Id& entry = this->table[this->Slot(id)];
  if (entry < 0)
  {
    entry = static_cast<Id>(this->ids.size());
    this->ids.push_back(id);
  }
  return entry;
}

void SheetStencil::Numbering::Clear()
{
  std::fill(this->table.begin(), this->table.end(), -1);
  this->ids.clear();
}

SheetStencil::SheetStencil(const TriangleComplex& surface, const SheetNeighbours& neighbours)
  : Surface(surface)
  , Neighbours(neighbours)
{
}

void SheetStencil::Gather(const Vec3& centre, Id seed, double radius)
{
  this->Triangles.Clear();
  this->Corners.Clear();
  this->Normals.clear();
  this->Triangles.Add(seed);
  const double radius2 = radius * radius;
  for (std::size_t i = 0; i < this->Triangles.ids.size(); ++i)
  {
    const Id t = this->Triangles.ids[i];
    const Triangle& c = this->Surface.triangles[U(t)];
    const Vec3 area = AreaVector2(this->Surface.points, c);
    std::array<bool, 3> inside{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id number = this->Corners.Add(c[k]);
      if (U(number) == this->Normals.size())
      {
        this->Normals.emplace_back();
      }
      this->Normals[U(number)] += area;
      inside[k] = Norm2(this->Surface.points[U(c[k])] - centre) < radius2;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id next = this->Neighbours[U(t)][k];
      if (next >= 0 && (inside[k] || inside[(k + 1) % 3]) && this->Triangles.ids.size() < MostTriangles)
      {
        this->Triangles.Add(next);
      }
    }
  }
}

} // namespace lamina
