// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The field along a ray in a cell, in single precision. Included by kernels once for each kind of
// vectors, hence the toggling guard.
#if defined(TemporalCoherence_CellCubics_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_CellCubics_inl_h
#undef TemporalCoherence_CellCubics_inl_h
#else
#define TemporalCoherence_CellCubics_inl_h
#endif

#include "Lattice/KernelsBeam.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, WidestVector>;
using Integers = hn::RebindToSigned<Floats>;
using V = hn::Vec<Floats>;
using M = hn::Mask<Floats>;

HWY_INLINE V Load(const float* from)
{
  return hn::LoadU(Floats(), from);
}

HWY_INLINE V Set(float value)
{
  return hn::Set(Floats(), value);
}

/// One bit for each lane.
template <class D>
HWY_INLINE std::uint64_t BitsIn(D d, hn::Mask<D> mask)
{
  std::uint8_t bits[8] = { 0 };
  hn::StoreMaskBits(d, mask, bits);
  return static_cast<std::uint64_t>(bits[0]) | static_cast<std::uint64_t>(bits[1]) << 8;
}
HWY_INLINE std::uint64_t BitsOf(M mask)
{
  return BitsIn(Floats(), mask);
}

HWY_INLINE M MaskOf(std::uint64_t which)
{
  const std::uint8_t bits[8] = { static_cast<std::uint8_t>(which),
    static_cast<std::uint8_t>(which >> 8) };
  return hn::LoadMaskBits(Floats(), bits);
}

/// Bernstein coefficients, of which the smallest and largest bound the cubic.
struct Coefficients
{
  V First, Second, Third, Last;
  V Smallest, Largest;
  V LargestRise; ///< from one coefficient to the next
};

/// The cubic along paths from `at` on, in cell coordinates.
HWY_INLINE Coefficients CubicsAlong(const CellValues& cell, const V at[3], const V step[3])
{
  // Powers of the share of the path: linear along x, quadratic along x and y, then cubic.
  V line0[4], line1[4], square0[2], square1[2], square2[2];
  for (std::size_t row = 0; row < 4; ++row)
  {
    const V slope = Set(cell.Step[row]);
    line0[row] = hn::MulAdd(slope, at[0], Set(cell.Low[row]));
    line1[row] = hn::Mul(slope, step[0]);
  }
  for (std::size_t z = 0; z < 2; ++z)
  {
    const V rise0 = hn::Sub(line0[2 * z + 1], line0[2 * z]);
    const V rise1 = hn::Sub(line1[2 * z + 1], line1[2 * z]);
    square0[z] = hn::MulAdd(at[1], rise0, line0[2 * z]);
    square1[z] = hn::MulAdd(step[1], rise0, hn::MulAdd(at[1], rise1, line1[2 * z]));
    square2[z] = hn::Mul(step[1], rise1);
  }
  const V rise0 = hn::Sub(square0[1], square0[0]), rise1 = hn::Sub(square1[1], square1[0]);
  const V rise2 = hn::Sub(square2[1], square2[0]);
  const V c0 = hn::MulAdd(at[2], rise0, square0[0]);
  const V c1 = hn::MulAdd(step[2], rise0, hn::MulAdd(at[2], rise1, square1[0]));
  const V c2 = hn::MulAdd(step[2], rise1, hn::MulAdd(at[2], rise2, square2[0]));
  const V c3 = hn::Mul(step[2], rise2);

  const V third = Set(1.0f / 3.0f);
  const V b1 = hn::MulAdd(c1, third, c0);
  const V b2 = hn::MulAdd(hn::Add(c1, c2), third, b1);
  const V b3 = hn::Add(hn::Add(c0, c1), hn::Add(c2, c3));
  const V rise = hn::Max(hn::Sub(b1, c0), hn::Max(hn::Sub(b2, b1), hn::Sub(b3, b2)));
  return { c0, b1, b2, b3, hn::Min(hn::Min(c0, b1), hn::Min(b2, b3)),
    hn::Max(hn::Max(c0, b1), hn::Max(b2, b3)), rise };
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
