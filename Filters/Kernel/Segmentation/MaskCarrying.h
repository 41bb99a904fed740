// SPDX-License-Identifier: BSD-3-Clause
// The inner steps of mask propagation: registration across a gap, its slices, and the judgement of methods.
#pragma once

#include "CarriedSlice.h"
#include "MaskSlices.h"
#include "SliceRegistration.h"

namespace lamina
{

constexpr std::size_t CarryMethods = 3;

/// The displacements of a gap: from each of its slices, drawn ones included, to the drawn slice below and to
/// that above. Empty where there is no such slice, or nothing is registered.
struct GapFields
{
  std::vector<SliceField> toLow;
  std::vector<SliceField> toHigh;
};

/// What each method makes of the slices of a gap.
struct GapSlices
{
  std::array<std::vector<std::vector<unsigned short>>, CarryMethods> labels;
  std::array<std::vector<double>, CarryMethods> residuals;
};

/// The displacements from the drawn slices at the ends of a gap to the ones at its other ends.
struct GapEnds
{
  SliceField highToLow;
  SliceField lowToHigh;
};

/// Everything that a run works with.
struct CarryWork
{
  SliceGrid grid;
  std::vector<int> ids;
  std::vector<DrawnSlice> drawn;
  std::vector<MaskGap> gaps;
  SliceStack stack;
  std::vector<CarryMethod> methods; ///< those to try
  SliceRegistrationOptions registration;
  const SliceWarper* warper = nullptr;

  bool Registers() const { return this->methods.back() != CarryMethod::Shape; }
  const SliceImage* Grey(Id slice) const
  {
    return this->stack.IsConstant() ? nullptr : &this->stack.slices[static_cast<std::size_t>(slice)];
  }
  const DrawnSlice* Drawn(Id index) const
  {
    return index >= 0 ? &this->drawn[static_cast<std::size_t>(index)] : nullptr;
  }
};

/// What two drawn slices, either of which may be missing, look like from a slice between them; the fields
/// lead there and may be null for CarryMethod::Shape.
std::vector<CarriedSource> SourcesOf(const CarryWork& work, Id slice, const DrawnSlice* low,
                                     const SliceField* toLow, const DrawnSlice* high,
                                     const SliceField* toHigh);

/// Register the slices of a gap with their neighbours, and chain the displacements up to the drawn slices.
void RegisterGap(const CarryWork& work, const MaskGap& gap, GapFields& fields, Monitor& monitor);

/// Make the slices of a gap by each of the methods.
void FillGap(const CarryWork& work, const MaskGap& gap, const GapFields& fields, GapSlices& slices,
             Monitor& monitor);

/// How well methods foretell drawn slices from their neighbours.
struct Foretold
{
  std::array<double, CarryMethods> dice{}; ///< by method; NaN: not measured
  Id worst = -1;                           ///< the slice that the last method foretells worst; -1: none
  double least = 1;                        ///< its Dice coefficient
};

/// Foretell every drawn slice between two others from those; if there are but two, each from the other.
/// `ends`: of each gap.
Foretold ForetellDrawn(const CarryWork& work, const std::vector<GapEnds>& ends, Monitor& monitor);

} // namespace lamina
