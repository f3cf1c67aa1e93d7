// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Which rays of a beam may pass a cell, and from where to where.
// Included by kernels once for each kind of vectors, hence the guard that turns over.
#if defined(TemporalCoherence_KernelsCellStays_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsCellStays_inl_h
#undef TemporalCoherence_KernelsCellStays_inl_h
#else
#define TemporalCoherence_KernelsCellStays_inl_h
#endif

#include "Beams/CellCubics-inl.h"
#include "Beams/KernelsBeamTree-inl.h"
#include "Beams/TileBeam.h"

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Between which distances rays may be in a cell.
struct CellStays
{
  float Enter[RayBatch::Capacity], Leave[RayBatch::Capacity];
};

/// Find out which rays of a beam may pass a cell on their walk.
/// \tparam IsPlain that of the beam
/// \return one bit for each ray
template <bool IsPlain, class Box>
HWY_INLINE std::uint64_t FindStays(const Box& box, const TileBeam& beam, CellStays& stays)
{
  const CellFaces faces(box, beam.Margin, beam.Flip);
  std::uint64_t passing = 0;
  for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(Floats()))
  {
    V enter = Set(-TileBeam::Never), leave = Set(TileBeam::Never);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V inverse = Load(&beam.Inverse[a][i]);
      if constexpr (IsPlain)
      {
        const V toOrigin = Load(&beam.ToOrigin[a][i]);
        enter = hn::Max(enter, hn::MulAdd(Set(faces.Near[a]), inverse, toOrigin));
        leave = hn::Min(leave, hn::MulAdd(Set(faces.Far[a]), inverse, toOrigin));
      }
      else
      {
        const V origin = Load(&beam.Origin[a][i]);
        enter = hn::Max(enter, hn::Mul(hn::Sub(Set(faces.Near[a]), origin), inverse));
        leave = hn::Min(leave, hn::Mul(hn::Sub(Set(faces.Far[a]), origin), inverse));
      }
    }
    if (!IsPlain)
    {
      enter = hn::Max(enter, Load(&beam.Begin[i]));
    }
    const M isAhead = hn::Le(enter, hn::Min(leave, Load(&beam.Behind[i])));
    passing |= BitsOf(hn::And(isAhead, hn::Ge(leave, Load(&beam.WalkBegin[i])))) << i;
    hn::StoreU(enter, Floats(), stays.Enter + i);
    hn::StoreU(leave, Floats(), stays.Leave + i);
  }
  return passing;
}

/// Those rays of a plain beam that surely enter no solid in a cell, as the field falls along them.
/// What is searched is as long as what was tested, but for the slack at both ends: at least half of
/// it. So its coefficients fall, too, half as much at least: by more than rounding may move them,
/// and their signs change once at most.
/// \param b     of the rays from number `i` on, in the cell between `enter` and `leave`
/// \param error of these coefficients
HWY_INLINE M CanOnlyExit(
  const TileBeam& beam, const Coefficients& b, V error, V enter, V leave, std::size_t i)
{
  const V end = hn::Min(leave, hn::Sub(Load(&beam.End[i]), Set(2.0f * beam.Margin)));
  const V slack = Load(&beam.Slack[i]), quarter = hn::Mul(Set(0.25f), hn::Sub(leave, enter));
  const M isLong = hn::And(hn::Lt(slack, quarter), hn::Lt(hn::Sub(leave, end), quarter));
  return hn::And(isLong, hn::Lt(b.LargestRise, hn::Mul(Set(-8.0f), error)));
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
