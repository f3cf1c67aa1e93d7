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

/// The points of the cells of a vector of rays.
template <class D>
struct KnownPoints
{
  using V = hn::Vec<D>;

  HWY_INLINE KnownPoints(const KnownTetrahedra& known, std::size_t i, std::size_t axis)
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

void KnownCrossingsOf(const KnownTetrahedra& known, const MeshRays& rays, Crossings& found)
{
  const Doubles d;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    ForEachVector(known.Rays & rays.Along[axis],
      [&](std::size_t i, std::uint64_t wanted) HWY_ATTR
      {
        const KnownPoints<Doubles> points(known, i, axis);
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
