// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Cells/KernelsKnownTetrahedra.h"

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/Cells/KernelsKnownTetrahedra.cxx"
#include <hwy/foreach_target.h>

#include "Mesh/Cells/KernelsTetrahedronSpan-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace MeshKernels
{
namespace HWY_NAMESPACE
{

/// The points of the cells of a vector of rays.
template <class D>
struct KnownPoints
{
  using V = hn::Vec<D>;

  HWY_INLINE KnownPoints(const SortedTetrahedra& known, std::size_t i, std::size_t axis)
    : Axes(TurnedAxes(axis))
    , Hand(hn::Load(D(), &known.Handedness[i]))
  {
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      V* const point = this->Points[corner];
      hn::LoadInterleaved4(
        D(), known.Corners[corner][i].data(), point[0], point[1], point[2], this->Values[corner]);
    }
  }
  HWY_INLINE V At(std::size_t corner, std::size_t a) const
  {
    return this->Points[corner][this->Axes[a]];
  }
  HWY_INLINE V Value(std::size_t corner) const { return this->Values[corner]; }
  HWY_INLINE V Handedness() const { return this->Hand; }

  std::array<glm::length_t, 3> Axes;
  V Points[4][3], Values[4], Hand;
};

/// Give each ray its cell.
/// \return bits of the rays with a cell; other rays get a cell without volume
HWY_INLINE std::uint64_t TakeCells(const SortedTetrahedra& tetrahedra,
  const TileArray<std::uint64_t>& cells, std::size_t count, SortedTetrahedra& ofRays)
{
  const hn::CappedTag<double, 4> d;
  const auto take = [&](std::uint64_t rays, const double* const from[4], double hand) HWY_ATTR
  {
    for (; rays != 0; rays &= rays - 1)
    {
      const std::size_t ray = hwy::Num0BitsBelowLS1Bit_Nonzero64(rays);
      for (std::size_t corner = 0; corner < 4; ++corner)
      {
        for (std::size_t i = 0; i < 4; i += hn::Lanes(d))
        {
          hn::StoreU(hn::LoadU(d, from[corner] + i), d, &ofRays.Corners[corner][ray][i]);
        }
      }
      ofRays.Handedness[ray] = hand;
    }
  };
  std::uint64_t all = 0;
  for (std::size_t cell = 0; cell < count; ++cell)
  {
    const double* const from[4] = { tetrahedra.Corners[0][cell].data(),
      tetrahedra.Corners[1][cell].data(), tetrahedra.Corners[2][cell].data(),
      tetrahedra.Corners[3][cell].data() };
    take(cells[cell], from, tetrahedra.Handedness[cell]);
    all |= cells[cell];
  }
  constexpr SortedTetrahedra::Corner none{};
  const double* const nothing[4] = { none.data(), none.data(), none.data(), none.data() };
  take(~all, nothing, 1.0);
  return all;
}

void KnownCrossingsOf(const SortedTetrahedra& tetrahedra, const TileArray<std::uint64_t>& cells,
  std::size_t count, const MeshRays& rays, KnownCrossings& found)
{
  const Doubles d;
  SortedTetrahedra ofRays;
  const std::uint64_t all = TakeCells(tetrahedra, cells, count, ofRays);
  constexpr double touching = 0x1p-36; // more than rounding errors of distances
  found.Met = found.Rising = found.AtEnds = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    ForEachVector(all & rays.Along[axis],
      [&](std::size_t i, std::uint64_t wanted) HWY_ATTR
      {
        const KnownPoints<Doubles> points(ofRays, i, axis);
        const auto span = FindSpan(d, ShearedRays<Doubles>(rays, i), points);
        const CrossingsOfSpan<Doubles> crossings(d, span, wanted);
        const std::uint64_t met = crossings.Met &
          BitsOf(d,
            hn::And(hn::Ge(crossings.T, hn::LoadU(d, &rays.Begin[i])),
              hn::Le(crossings.T, hn::LoadU(d, &rays.End[i]))));
        const std::uint8_t bits[8] = { static_cast<std::uint8_t>(met) };
        hn::BlendedStore(crossings.T, hn::LoadMaskBits(d, bits), d, &found.T[i]);
        const auto last = hn::Sub(span.Out, hn::Mul(hn::Set(d, touching), hn::Abs(span.Out)));
        found.AtEnds |= (met & BitsOf(d, hn::Ge(crossings.T, last))) << i;
        found.Met |= met << i;
        found.Rising |= crossings.Rising << i;
      });
  }
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace MeshKernels
{

HWY_EXPORT(KnownCrossingsOf);

void FindKnownCrossings(const SortedTetrahedra& tetrahedra, const TileArray<std::uint64_t>& cells,
  std::size_t count, const MeshRays& rays, KnownCrossings& found)
{
  HWY_DYNAMIC_DISPATCH(KnownCrossingsOf)(tetrahedra, cells, count, rays, found);
}

}
}
#endif
