// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/KernelsBlocked.h"

#include "Lattice/CellRoot.h"

#include <array>
#include <cstddef>
#include <cstdint>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Lattice/KernelsBlocked.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/KernelsSegment-inl.h"
#include "Lattice/KernelsWalk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;
namespace segments = SegmentKernels::HWY_NAMESPACE;
namespace walks = WalkKernels::HWY_NAMESPACE;

using walks::Doubles;
using walks::M;

/// Searches the cells that a vector of rays is in.
template <typename Real>
class BlockedVector
{
public:
  using Reals = hn::Rebind<Real, Doubles>;
  using R = hn::Vec<Reals>;

  HWY_INLINE BlockedVector(
    const BlockingScene<Real>& scene, const RayBatch& rays, std::size_t first)
    : Scene(scene)
    , Rays(segments::LoadRays(Doubles(), rays, first))
  {
  }

  /// Search the present cells.
  /// \param which one bit for each ray that is in an active cell
  /// \return one bit for each ray that meets a surface there
  HWY_INLINE std::uint64_t Search(const walks::WalkVector& vector, std::uint64_t which)
  {
    const Doubles d;
    const Reals dr;
    VectorCells<Real> cells;
    hn::Vec<Doubles> cell[3];
    for (std::size_t a = 0; a < 3; ++a)
    {
      cell[a] = vector.CellOf(a);
      hn::StoreU(cell[a], d, cells.Cell[a].data());
    }
    const auto path = segments::FindPath(d, this->Rays, cell);
    cells.Which = which & walks::BitsOfMask(hn::Lt(path.Enter, path.Leave));
    if (cells.Which == 0)
    {
      return 0;
    }
    std::array<std::array<Real, VectorCells<Real>::Capacity>, 3> begins, ends;
    R begin[3], end[3];
    for (std::size_t a = 0; a < 3; ++a)
    {
      segments::StoreAs(path.Begin[a], begins[a].data());
      segments::StoreAs(path.End[a], ends[a].data());
      begin[a] = hn::LoadU(dr, begins[a].data());
      end[a] = hn::LoadU(dr, ends[a].data());
    }
    std::uint64_t blocked = 0;
    for (std::size_t surface = 0; surface < this->Scene.Surfaces; ++surface)
    {
      this->Scene.Reader.Read(surface, cells);
      R v[8], b[4];
      for (std::size_t corner = 0; corner < 8; ++corner)
      {
        v[corner] = hn::LoadU(dr, cells.Corners[corner].data());
      }
      segments::CubicsBetween(dr, v, begin, end, b);
      blocked |= this->FindCrossing(b, cells.Which & ~blocked);
    }
    return blocked;
  }

private:
  /// The cubics, one bit each, that cross zero.
  HWY_INLINE std::uint64_t FindCrossing(const R b[4], std::uint64_t which) const
  {
    const Reals dr;
    const auto changes = segments::FindChanges(dr, b);
    const auto ends = hn::Ge(b[3], hn::Zero(dr));
    const auto isOdd = hn::Xor(changes.Begins, ends);
    std::uint64_t crossing = BitsOf(isOdd);
    if (this->Scene.IsSolid)
    {
      crossing |= BitsOf(changes.Begins);
    }
    // Two sign changes of the coefficients do not prove a crossing.
    const std::uint64_t open = BitsOf(changes.Any) & ~crossing & which;
    if (open != 0)
    {
      crossing |= CrossingAmong(b, open);
    }
    return crossing & which;
  }

  static HWY_NOINLINE std::uint64_t CrossingAmong(const R b[4], std::uint64_t open)
  {
    std::array<std::array<Real, VectorCells<Real>::Capacity>, 4> stored;
    for (std::size_t c = 0; c < 4; ++c)
    {
      hn::StoreU(b[c], Reals(), stored[c].data());
    }
    std::uint64_t crossing = 0;
    for (; open != 0; open &= open - 1)
    {
      const std::size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero64(open);
      Real share;
      const Cubic<Real> cubic{ stored[0][lane], stored[1][lane], stored[2][lane], stored[3][lane] };
      crossing |= static_cast<std::uint64_t>(FirstCrossing(cubic, share)) << lane;
    }
    return crossing;
  }

  static HWY_INLINE std::uint64_t BitsOf(hn::Mask<Reals> mask)
  {
    std::uint8_t bits[8] = { 0 };
    hn::StoreMaskBits(Reals(), mask, bits);
    return bits[0];
  }

  const BlockingScene<Real>& Scene;
  segments::RayVector<hn::Vec<Doubles>> Rays;
};

template <typename Real>
HWY_INLINE std::uint64_t FindBlockedAll(
  const BlockingScene<Real>& scene, const RayBatch& rays, std::int64_t& cellsRead)
{
  const Doubles d;
  std::uint64_t all = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); i += hn::Lanes(d))
  {
    walks::WalkVector vector(scene.Walks, rays, i);
    vector.Begin(rays, i);
    BlockedVector<Real> search(scene, rays, i);
    vector.Walk(
      [&](M isActive) HWY_ATTR
      {
        const std::uint64_t which = walks::BitsOfMask(isActive);
        if (which == 0)
        {
          return isActive;
        }
        cellsRead += static_cast<std::int64_t>(hwy::PopCount(which));
        const std::uint64_t blocked = search.Search(vector, which);
        all |= blocked << i;
        const std::uint8_t bits[8] = { static_cast<std::uint8_t>(blocked) };
        return hn::LoadMaskBits(d, bits);
      });
  }
  return all;
}

std::uint64_t FindBlockedFloat(
  const BlockingScene<float>& scene, const RayBatch& rays, std::int64_t& cellsRead)
{
  return FindBlockedAll(scene, rays, cellsRead);
}

std::uint64_t FindBlockedDouble(
  const BlockingScene<double>& scene, const RayBatch& rays, std::int64_t& cellsRead)
{
  return FindBlockedAll(scene, rays, cellsRead);
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(FindBlockedFloat);
HWY_EXPORT(FindBlockedDouble);

std::uint64_t FindBlocked(
  const BlockingScene<float>& scene, const RayBatch& rays, std::int64_t& cellsRead)
{
  return HWY_DYNAMIC_DISPATCH(FindBlockedFloat)(scene, rays, cellsRead);
}

std::uint64_t FindBlocked(
  const BlockingScene<double>& scene, const RayBatch& rays, std::int64_t& cellsRead)
{
  return HWY_DYNAMIC_DISPATCH(FindBlockedDouble)(scene, rays, cellsRead);
}

}
#endif
