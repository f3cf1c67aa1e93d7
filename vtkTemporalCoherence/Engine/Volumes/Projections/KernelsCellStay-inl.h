// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Paths of a beam's rays through a cell, in full precision. Kernels include this file once for each
// kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsCellStay_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsCellStay_inl_h
#undef TemporalCoherence_KernelsCellStay_inl_h
#else
#define TemporalCoherence_KernelsCellStay_inl_h
#endif

#include "Lattice/KernelsHull-inl.h"
#include "Lattice/KernelsLattice-inl.h"
#include "Lattice/KernelsSegment-inl.h"

#include <algorithm>
#include <cmath>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace ExtremeKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;
namespace beams = BeamKernels::HWY_NAMESPACE;
namespace segments = SegmentKernels::HWY_NAMESPACE;

using beams::BitsIn;
using beams::BitsOf;
using beams::Floats;
using beams::Interval;
using beams::Load;
using beams::M;
using beams::Set;
using beams::V;
using Doubles = hn::CappedTag<double, WidestVector / 2>;

/// A box in the coordinates of a beam, for CellFaces.
struct BeamBox
{
  HWY_INLINE float Low(std::size_t a) const { return this->Lows[a]; }
  HWY_INLINE float High(std::size_t a) const { return this->Highs[a]; }

  float Lows[3], Highs[3];
};

/// Coordinates of the planes of a field.
struct UniformPlanes
{
  static constexpr bool AreUnits = true;
  using Lattice = beams::UniformLattice;

  double At(int, int plane) const { return plane; }
  static Lattice LatticeFor(const TileBeam& beam, const GridCoordinates*) { return Lattice(beam); }

  const GridCoordinates* Grid;
};

struct RectilinearPlanes
{
  static constexpr bool AreUnits = false;
  using Lattice = beams::RectilinearLattice;

  double At(int axis, int plane) const { return this->Grid->At(axis, plane); }
  static Lattice LatticeFor(const TileBeam& beam, const GridCoordinates* grid)
  {
    return Lattice(beam, *grid);
  }

  const GridCoordinates* Grid;
};

/// The box around a block of cells.
/// \param cells of the field along each axis
template <class Planes>
HWY_INLINE BeamBox BoxOf(const Planes& planes, const TileBeam& beam, const glm::ivec3& cells,
  const glm::ivec3& first, int size)
{
  BeamBox box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double anchor = beam.Anchor[axis];
    const int last = std::min(first[axis] + size, cells[axis]);
    box.Lows[axis] = static_cast<float>(planes.At(axis, first[axis]) - anchor);
    box.Highs[axis] = static_cast<float>(planes.At(axis, last) - anchor);
  }
  return box;
}

/// The distance of a block along a beam, to compare blocks of one size.
HWY_INLINE float DepthOf(const TileBeam& beam, const glm::ivec3& block, int size)
{
  float depth = 0.0f;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool isBack = beam.Flip >> (2 * axis) & 1;
    depth += static_cast<float>((isBack ? -block[axis] : block[axis]) * size) *
      std::abs(beam.Forward[axis]);
  }
  return depth;
}

/// Paths of a vector of rays through a cell: distances, and ends in the coordinates of the cell.
template <typename Real>
struct alignas(64) CellStay
{
  double Enter[WidestVector], Leave[WidestVector];
  Real Begin[3][WidestVector], End[3][WidestVector];
};

/// \param first ray of the vector
/// \return one bit for each ray that passes the cell, not only touches it
template <class Planes, typename Real>
HWY_INLINE std::uint64_t FindStay(const Planes& planes, const glm::ivec3& cell,
  const RayBatch& rays, std::size_t first, CellStay<Real>& stay)
{
  const Doubles d;
  hn::Vec<Doubles> low[3], high[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = hn::Set(d, planes.At(axis, cell[axis]));
    high[axis] = hn::Set(d, planes.At(axis, cell[axis] + 1));
  }
  std::uint64_t pass = 0;
  constexpr std::size_t lanes = hn::MaxLanes(hn::CappedTag<Real, WidestVector>());
  for (std::size_t i = 0; i < lanes; i += hn::Lanes(d))
  {
    const auto path =
      segments::FindPath<Planes::AreUnits>(d, segments::LoadRays(d, rays, first + i), low, high);
    for (std::size_t a = 0; a < 3; ++a)
    {
      segments::StoreAs(path.Begin[a], &stay.Begin[a][i]);
      segments::StoreAs(path.End[a], &stay.End[a][i]);
    }
    hn::StoreU(path.Enter, d, &stay.Enter[i]);
    hn::StoreU(path.Leave, d, &stay.Leave[i]);
    pass |= BitsIn(d, hn::Lt(path.Enter, path.Leave)) << i;
  }
  return pass;
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
