// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Bounds of the largest values, in single precision: of the samples of each cell of a leaf, and of
// a beam's rays in a cell. Kernels include this file once for each kind of vectors, hence the
// toggling guard.
#if defined(TemporalCoherence_KernelsCellBounds_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsCellBounds_inl_h
#undef TemporalCoherence_KernelsCellBounds_inl_h
#else
#define TemporalCoherence_KernelsCellBounds_inl_h
#endif

#include "Lattice/CellCubics-inl.h"
#include "Lattice/KernelsLattice-inl.h"
#include "Volumes/Projections/ExtremeBlocks.h"
#include "Volumes/Projections/KernelsCellStay-inl.h"

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

/// Store numbers as floats, rounded up.
template <class D, class Vector = hn::Vec<D>>
HWY_INLINE void StoreRoundedUp(D d, Vector values, float* to)
{
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(float))
  {
    hn::StoreU(values, d, to);
  }
  else
  {
    const hn::Rebind<float, D> df;
    const Vector bounded = hn::Max(values, hn::Set(d, -3e38));
    const auto isLess = hn::Lt(hn::PromoteTo(d, hn::DemoteTo(df, bounded)), bounded);
    const Vector more =
      hn::MulAdd(hn::Abs(bounded), hn::Set(d, 0x1p-22), hn::Add(bounded, hn::Set(d, 1e-37)));
    hn::StoreU(hn::DemoteTo(df, hn::IfThenElse(isLess, more, bounded)), df, to);
  }
}

/// The smallest and the largest sample of each cell of a leaf, including cells beyond the field.
template <typename Real>
struct alignas(64) CellEnds
{
  std::array<Real, 64> Smallest, Largest;
};

/// \param bounds get the largest samples, rounded up
template <typename Real>
HWY_INLINE void FindEnds(
  const ExtremeLeaf<Real>& leaf, CellEnds<Real>& ends, std::array<float, 64>& bounds)
{
  constexpr std::size_t cells = ValueRangePyramid::LeafSize, edge = ExtremeLeaf<Real>::Edge;
  const hn::CappedTag<Real, cells> d;
  using Vector = hn::Vec<decltype(d)>;
  for (std::size_t x = 0; x < cells; x += hn::Lanes(d))
  {
    const Vector none = hn::Zero(d);
    Vector low[cells] = { none, none, none, none }, high[cells] = { none, none, none, none };
    for (std::size_t z = 0; z < edge; ++z)
    {
      Vector lowBefore = none, highBefore = none; // of the row before; above, of the plane before
      for (std::size_t y = 0; y < edge; ++y)
      {
        const Vector here = hn::LoadU(d, leaf.Row(y, z) + x);
        const Vector next = hn::LoadU(d, leaf.Row(y, z) + x + 1);
        const Vector lowRow = hn::Min(here, next), highRow = hn::Max(here, next);
        if (y > 0)
        {
          const Vector lowPlane = hn::Min(lowBefore, lowRow);
          const Vector highPlane = hn::Max(highBefore, highRow);
          if (z > 0)
          {
            const std::size_t cell = 16 * (z - 1) + 4 * (y - 1) + x;
            const Vector largest = hn::Max(high[y - 1], highPlane);
            hn::StoreU(hn::Min(low[y - 1], lowPlane), d, &ends.Smallest[cell]);
            hn::StoreU(largest, d, &ends.Largest[cell]);
            StoreRoundedUp(d, largest, &bounds[cell]);
          }
          low[y - 1] = lowPlane;
          high[y - 1] = highPlane;
        }
        lowBefore = lowRow;
        highBefore = highRow;
      }
    }
  }
}

/// Mask of the bounds from `least` on, without minus infinity.
HWY_INLINE std::uint64_t FindAtLeast(const std::array<float, 64>& bounds, float least)
{
  const auto threshold = beams::Set(std::max(least, std::numeric_limits<float>::lowest()));
  std::uint64_t found = 0;
  for (std::size_t i = 0; i < bounds.size(); i += hn::Lanes(beams::Floats()))
  {
    found |= beams::BitsOf(hn::Ge(beams::Load(&bounds[i]), threshold)) << i;
  }
  return found;
}

/// Bounds of the largest values of a vector of rays in a cell.
struct MetValues
{
  V Most;  ///< upper bounds
  V Least; ///< lower bounds; minus infinity for rays that may miss the cell
};

/// LargestOf of KernelsLargest-inl.h for coefficients that are not much larger than 1: as exact as
/// single precision, but not the same bits.
HWY_INLINE void FindLargest(const beams::Coefficients& b, V& value, V& share)
{
  const Floats d;
  const V zero = hn::Zero(d), one = Set(1.0f);
  const M isLast = hn::Gt(b.Last, b.First);
  value = hn::Max(b.First, b.Last);
  share = hn::IfThenElseZero(isLast, one);
  const M mayTurn = hn::Gt(b.Largest, value);
  if (hn::AllFalse(d, mayTurn))
  {
    return;
  }
  // A third of the derivative is rise + 2 bend s + turn s^2. It falls through zero where its own
  // derivative is minus twice the root.
  const V rise = hn::Sub(b.Second, b.First), next = hn::Sub(b.Third, b.Second);
  const V bend = hn::Sub(next, rise);
  const V turn = hn::Sub(hn::Sub(hn::Sub(b.Last, b.Third), next), bend);
  const V discriminant = hn::NegMulAdd(turn, rise, hn::Mul(bend, bend));
  const V root = hn::Sqrt(hn::Max(discriminant, zero));
  const M isRising = hn::Gt(bend, zero);
  const V numerator = hn::IfThenElse(isRising, hn::Neg(hn::Add(bend, root)), rise);
  const V denominator = hn::IfThenElse(isRising, turn, hn::Sub(root, bend));
  const V s = hn::Div(numerator, denominator);
  const M isWithin = hn::And(mayTurn, hn::And(hn::Gt(s, zero), hn::Lt(s, one)));
  const V three = Set(3.0f), inside = hn::IfThenElseZero(isWithin, s);
  const V slope =
    hn::MulAdd(inside, hn::MulAdd(inside, turn, hn::Mul(three, bend)), hn::Mul(three, rise));
  const V at = hn::MulAdd(inside, slope, b.First);
  const M isMore = hn::And(isWithin, hn::Gt(at, value));
  value = hn::IfThenElse(isMore, at, value);
  share = hn::IfThenElse(isMore, inside, share);
}

/// Bounds the values of a beam's rays in a cell. Values are scaled to [0, 1] from the smallest to
/// the largest sample, so that single precision loses little where the field is smooth.
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
    , Spread(static_cast<float>(cell.Largest - cell.Smallest))
  {
    const float margin = beam.Margin * box.LargestShare();
    this->IsKnown = margin < 0x1p-5f && this->Spread < 1e30f;
    const float unit = 1.0f / std::max(this->Spread, 1e-30f);
    for (std::size_t row = 0; row < 4; ++row)
    {
      const auto low = static_cast<float>(cell.Samples[2 * row] - cell.Smallest);
      const auto high = static_cast<float>(cell.Samples[2 * row + 1] - cell.Smallest);
      this->Values.Low[row] = unit * low;
      this->Values.Step[row] = unit * (high - low);
    }
    if (cell.Largest > cell.Smallest)
    {
      // The error of isosurfaces (CellSearch::ErrorIn), and of adding the smallest sample.
      this->Error = this->Spread * (16.0f * margin + 0x1p-12f) + 1e-30f +
        0x1p-22f * std::max(std::abs(this->Above), std::abs(this->Bound));
      this->Slope = 2.25f * beam.Steepest * this->Spread * box.LargestShare();
    }
  }

  /// \param searched interval in which the rays may be in the cell
  /// \param reached  largest values so far; if the cell stays below them, only Most is found
  HWY_INLINE MetValues Meet(const Interval& searched, V reached, std::size_t i) const
  {
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
    const V spread = Set(this->Spread), error = Set(this->Error);
    const V above = hn::Add(Set(this->Above), error);
    const V most = hn::Min(bound, hn::MulAdd(spread, b.Largest, above));
    if (hn::AllFalse(Floats(), hn::Ge(most, reached)))
    {
      return { most, nothing };
    }
    V value, share;
    FindLargest(b, value, share);
    const Interval sure = this->FindSure(searched, i);
    const V where = hn::MulAdd(share, hn::Sub(within.Leave, within.Enter), within.Enter);
    const V held = hn::Min(hn::Max(where, sure.Enter), sure.Leave);
    const V moved = hn::MulAdd(Set(this->Slope), hn::Abs(hn::Sub(where, held)), error);
    const V least = hn::MulAdd(spread, value, hn::Sub(Set(this->Below), moved));
    return { hn::Min(most, hn::MulAdd(spread, value, above)),
      hn::IfThenElse(hn::Le(sure.Enter, sure.Leave), least, nothing) };
  }

private:
  /// The interval in which rays are in the cell for certain.
  HWY_INLINE Interval FindSure(const Interval& searched, std::size_t i) const
  {
    const TileBeam& beam = this->Beam;
    Interval sure;
    if (beam.IsPlain)
    {
      const V slack = Load(&beam.Slack[i]);
      sure = { hn::Add(searched.Enter, slack), hn::Sub(searched.Leave, slack) };
    }
    else
    {
      sure = beams::FindInterval(this->Inner, beam.Origin, beam.Inverse, i);
    }
    const V margin = Set(2.0f * beam.Margin);
    return { hn::Max(sure.Enter, hn::Add(Load(&beam.Begin[i]), margin)),
      hn::Min(sure.Leave, hn::Sub(Load(&beam.End[i]), margin)) };
  }

  const Box& Place;
  const TileBeam& Beam;
  beams::CellFaces Inner;    ///< faces of the cell, moved inwards
  float Bound, Above, Below; ///< of the largest sample; of the smallest one
  float Spread;              ///< largest minus smallest sample
  CellValues Values;         ///< scaled to [0, 1]
  float Error = 0.0f;        ///< of values, at most
  float Slope = 0.0f;        ///< of values along rays, at most
  bool IsKnown;              ///< single precision is exact enough
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
