// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/KernelsKnownTetrahedra.h"

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/KernelsKnownTetrahedra.cxx"
#include <hwy/foreach_target.h>

#include "Mesh/KernelsTetrahedronSpan-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace MeshKernels
{
namespace HWY_NAMESPACE
{

/// The points of a cell for each lane, among those of a tile.
template <class D>
struct ChosenPoints
{
  using V = hn::Vec<D>;
  using Indices = hn::RebindToSigned<D>;
  static constexpr std::size_t Stride = sizeof(TetrahedronPoints) / sizeof(double);

  HWY_INLINE ChosenPoints(const KnownTetrahedra& known, std::size_t i, std::size_t axis)
    : Axes(TurnedAxes(axis))
    , First(known.Cells[0])
  {
    HWY_ALIGN std::int64_t from[hn::MaxLanes(D())];
    for (std::size_t lane = 0; lane < hn::Lanes(D()); ++lane)
    {
      from[lane] = static_cast<std::int64_t>(known.Cell[i + lane] * Stride);
    }
    this->From = hn::Load(Indices(), from);
  }
  HWY_INLINE V At(std::size_t corner, std::size_t a) const
  {
    return hn::GatherIndex(D(), &this->First.Points[corner][this->Axes[a]], this->From);
  }
  HWY_INLINE V Value(std::size_t corner) const
  {
    return hn::GatherIndex(D(), &this->First.Values[corner], this->From);
  }
  HWY_INLINE V Handedness() const
  {
    return hn::GatherIndex(D(), &this->First.Handedness, this->From);
  }

  std::array<glm::length_t, 3> Axes;
  const TetrahedronPoints& First;
  hn::Vec<Indices> From;
};

void KnownCrossingsOf(const KnownTetrahedra& known, const MeshRays& rays, Crossings& found)
{
  const Doubles d;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    ForEachVector(known.Rays & rays.Along[axis],
      [&](std::size_t i, std::uint64_t wanted) HWY_ATTR
      {
        const ChosenPoints<Doubles> points(known, i, axis);
        AppendCrossings(
          d, FindSpan(d, ShearedRays<Doubles>(rays, i), points), rays, i, wanted, found);
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

void KnownTetrahedronCrossings(
  const KnownTetrahedra& tetrahedra, const MeshRays& rays, Crossings& found)
{
  HWY_DYNAMIC_DISPATCH(KnownCrossingsOf)(tetrahedra, rays, found);
}

}
}
#endif
