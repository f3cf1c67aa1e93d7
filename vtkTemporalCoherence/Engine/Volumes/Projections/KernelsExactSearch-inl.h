// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The largest values of rays in a cell, in full precision. Kernels include this file once for each
// kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsExactSearch_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsExactSearch_inl_h
#undef TemporalCoherence_KernelsExactSearch_inl_h
#else
#define TemporalCoherence_KernelsExactSearch_inl_h
#endif

#include "Volumes/Projections/KernelsCellStay-inl.h"
#include "Volumes/Projections/KernelsExtremes.h"
#include "Volumes/Projections/KernelsLargest-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace ExtremeKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Searches single cells, with the same bits as ExtremeWalk.
template <typename Real, class Planes>
class ExactSearch
{
public:
  /// \param meeting with nearest interpolation: searches cells; else null
  ExactSearch(const Planes& planes, const CellMeeting<Real>* meeting, const RayBatch& rays,
    BeamExtremes<Real>& found)
    : Between(planes)
    , Meeting(meeting)
    , Rays(rays)
    , Found(found)
  {
  }

  /// Search a cell for some rays, one bit each, of a vector of floats.
  /// \param first ray of the vector
  /// \return one bit for each ray of the tile with a new extreme: larger, or equal and nearer
  std::uint64_t Search(const ExtremeCell<Real>& cell, std::size_t first, std::uint64_t which)
  {
    constexpr std::size_t lanes = hn::MaxLanes(hn::CappedTag<Real, WidestVector>());
    constexpr std::uint64_t these = (std::uint64_t(1) << lanes) - 1;
    std::uint64_t kept = 0;
    for (; which != 0; which >>= lanes, first += lanes)
    {
      const std::uint64_t now = which & these;
      if (now != 0)
      {
        kept |=
          (this->Meeting ? this->MeetEach(cell, first, now) : this->SearchVector(cell, first, now))
          << first;
      }
    }
    return kept;
  }

private:
  std::uint64_t MeetEach(const ExtremeCell<Real>& cell, std::size_t first, std::uint64_t which)
  {
    std::uint64_t kept = 0;
    for (; which != 0; which &= which - 1)
    {
      const std::size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero64(which);
      Real value;
      double at;
      if (this->Meeting->Meet(this->Rays, first + i, cell, value, at))
      {
        kept |= static_cast<std::uint64_t>(this->Keep(first + i, value, at)) << i;
      }
    }
    return kept;
  }

  /// Search a cell for some rays, one bit each, of a vector.
  /// \return one bit for each ray of the vector with a new extreme
  HWY_INLINE std::uint64_t SearchVector(
    const ExtremeCell<Real>& cell, std::size_t first, std::uint64_t which)
  {
    CellStay<Real> stays;
    which &= FindStay(this->Between, cell.Place, this->Rays, first, stays);
    if (which == 0)
    {
      return 0;
    }
    const hn::CappedTag<Real, WidestVector> d;
    using Vector = hn::Vec<decltype(d)>;
    Vector corners[8], begin[3], end[3], b[4];
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      corners[corner] = hn::Set(d, cell.Samples[corner]);
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      begin[a] = hn::LoadU(d, stays.Begin[a]);
      end[a] = hn::LoadU(d, stays.End[a]);
    }
    segments::CubicsBetween(d, corners, begin, end, b);
    const Vector smallest = hn::Set(d, cell.Smallest), largest = hn::Set(d, cell.Largest);
    for (Vector& coefficient : b)
    {
      coefficient = hn::Min(hn::Max(coefficient, smallest), largest);
    }
    const Vector reached = hn::LoadU(d, &this->Found.Value[first]);
    const Vector most = hn::Max(hn::Max(b[0], b[1]), hn::Max(b[2], b[3]));
    if (hn::AllFalse(d, hn::Ge(most, reached)) && hn::AllFalse(d, hn::Ge(smallest, reached)))
    {
      return 0;
    }
    Vector value, share;
    LargestOf(d, b, most, value, share);
    value = hn::Min(hn::Max(value, smallest), largest);
    which &= BitsIn(d, hn::Ge(value, reached));
    alignas(64) Real values[WidestVector], shares[WidestVector];
    hn::Store(value, d, values);
    hn::Store(share, d, shares);
    std::uint64_t kept = 0;
    for (; which != 0; which &= which - 1)
    {
      const std::size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero64(which);
      const double at =
        stays.Enter[i] + static_cast<double>(shares[i]) * (stays.Leave[i] - stays.Enter[i]);
      kept |= static_cast<std::uint64_t>(this->Keep(first + i, values[i], at)) << i;
    }
    return kept;
  }

  HWY_INLINE bool Keep(std::size_t ray, Real value, double at)
  {
    const Real before = this->Found.Value[ray];
    const bool isKept = value > before || (value == before && at < this->Found.First[ray]);
    if (isKept)
    {
      this->Found.Value[ray] = value;
      this->Found.First[ray] = at;
    }
    return isKept;
  }

  Planes Between;
  const CellMeeting<Real>* Meeting;
  const RayBatch& Rays;
  BeamExtremes<Real>& Found;
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
