// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Bounds of the largest values that rays of a beam meet in a cell, in single precision.
// Included by kernels once for each kind of vectors, hence the guard that turns over.
#if defined(TemporalCoherence_KernelsCellBounds_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsCellBounds_inl_h
#undef TemporalCoherence_KernelsCellBounds_inl_h
#else
#define TemporalCoherence_KernelsCellBounds_inl_h
#endif

#include "Beams/KernelsLattice-inl.h"
#include "Projections/ExtremeBlocks.h"
#include "Projections/KernelsCellStay-inl.h"
#include "Projections/KernelsLargest-inl.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace ExtremeKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// From where to where a vector of rays is in a box.
struct Interval
{
  V Enter, Leave;
};

HWY_INLINE Interval FindPassage(const TileBeam& beam, const beams::CellFaces& faces, std::size_t i)
{
  Interval passage{ Set(-TileBeam::Never), Set(TileBeam::Never) };
  for (std::size_t a = 0; a < 3; ++a)
  {
    const V origin = Load(&beam.Origin[a][i]), inverse = Load(&beam.Inverse[a][i]);
    passage.Enter = hn::Max(passage.Enter, hn::Mul(hn::Sub(Set(faces.Near[a]), origin), inverse));
    passage.Leave = hn::Min(passage.Leave, hn::Mul(hn::Sub(Set(faces.Far[a]), origin), inverse));
  }
  return passage;
}

/// What a vector of rays meets in a cell.
struct MetValues
{
  V Most;  ///< they meet no more
  V Least; ///< their largest value is not less; minus infinity where it is not sure that they meet
           ///< it
};

/// A cell that rays of a beam meet. Values are counted from its smallest one, so that what single
/// precision loses is little where the field is smooth.
template <typename Real, class Box>
class BoundedCell
{
public:
  BoundedCell(const ExtremeCell<Real>& cell, float bound, const Box& box, const TileBeam& beam)
    : Place(box)
    , Beam(beam)
    , Inner(box, -beam.Margin, beam.Flip)
    , Bound(bound)
    , Above(RoundedUp(cell.Smallest))
    , Below(RoundedDown(cell.Smallest))
  {
    const auto spread = static_cast<float>(cell.Largest - cell.Smallest);
    const float margin = beam.Margin * box.LargestShare();
    this->IsKnown = margin < 0x1p-5f && spread < 1e30f;
    for (std::size_t row = 0; row < 4; ++row)
    {
      this->Values.Set(row, static_cast<float>(cell.Samples[2 * row] - cell.Smallest),
        static_cast<float>(cell.Samples[2 * row + 1] - cell.Smallest));
    }
    if (cell.Largest > cell.Smallest)
    {
      // As for isosurfaces (CellSearch::ErrorIn), and what is lost where the smallest is added.
      this->Error = spread * (16.0f * margin + 0x1p-12f) + 1e-30f +
        0x1p-22f * std::max(std::abs(this->Above), std::abs(this->Bound));
      this->Slope = 2.25f * beam.Steepest * spread * box.LargestShare();
    }
  }

  /// \param searched from where to where the rays can be in the cell
  /// \param reached  what they have met; if they meet less than that here, no more is found out
  HWY_INLINE MetValues Meet(const Interval& searched, V reached, std::size_t i) const
  {
    const Floats d;
    const V nothing = Set(-std::numeric_limits<float>::infinity()), bound = Set(this->Bound);
    if (!this->IsKnown)
    {
      return { bound, nothing };
    }
    const TileBeam& beam = this->Beam;
    const Interval within{ hn::Max(searched.Enter, Load(&beam.Begin[i])),
      hn::Min(searched.Leave, Load(&beam.End[i])) };
    V at[3], step[3];
    beams::FindPathsIn(this->Place, beam, within.Enter, within.Leave, i, at, step);
    const beams::Coefficients b = beams::CubicsAlong(this->Values, at, step);
    const V above = Set(this->Above), error = Set(this->Error);
    const V most = hn::Min(bound, hn::Add(above, hn::Add(b.Largest, error)));
    if (hn::AllFalse(d, hn::Ge(most, reached)))
    {
      return { most, nothing };
    }
    const V all[4] = { b.First, b.Second, b.Third, b.Last };
    V value, share;
    LargestOf(d, all, b.Largest, value, share);
    // The ray is in the cell for sure between these.
    const V margin = Set(2.0f * beam.Margin);
    Interval sure = FindPassage(beam, this->Inner, i);
    sure.Enter = hn::Max(sure.Enter, hn::Add(Load(&beam.Begin[i]), margin));
    sure.Leave = hn::Min(sure.Leave, hn::Sub(Load(&beam.End[i]), margin));
    const V where = hn::MulAdd(share, hn::Sub(within.Leave, within.Enter), within.Enter);
    const V held = hn::Min(hn::Max(where, sure.Enter), sure.Leave);
    const V moved = hn::MulAdd(Set(this->Slope), hn::Abs(hn::Sub(where, held)), error);
    const V least = hn::Add(Set(this->Below), hn::Sub(value, moved));
    return { hn::Min(most, hn::Add(above, hn::Add(value, error))),
      hn::IfThenElse(hn::Le(sure.Enter, sure.Leave), least, nothing) };
  }

private:
  const Box& Place;
  const TileBeam& Beam;
  beams::CellFaces Inner;    ///< its faces, moved inwards
  float Bound, Above, Below; ///< of the largest value; of the smallest one
  CellValues Values;
  float Error = 0.0f; ///< of values, by which they may be off
  float Slope = 0.0f; ///< how fast they change along rays
  bool IsKnown;       ///< single precision tells something
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
