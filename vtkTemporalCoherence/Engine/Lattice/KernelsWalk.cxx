// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/KernelsWalk.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Lattice/KernelsWalk.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/KernelsWalk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using WalkKernels::HWY_NAMESPACE::BitsOfMask;
using WalkKernels::HWY_NAMESPACE::Doubles;
using WalkKernels::HWY_NAMESPACE::M;
using WalkKernels::HWY_NAMESPACE::WalkVector;

/// Begin the walks of a vector, or go on with them.
HWY_INLINE void Resume(const RayWalks& walks, std::size_t first, WalkVector& vector)
{
  if (walks.HasBegun)
  {
    vector.GoOn(walks, first);
  }
  else
  {
    vector.Begin(walks.Rays, first);
  }
}

HWY_INLINE void StoreCells(const WalkVector& vector, std::size_t first, RayWalks& walks)
{
  for (std::size_t a = 0; a < 3; ++a)
  {
    hn::StoreU(vector.CellOf(a), Doubles(), &walks.Cell[a][first]);
  }
}

/// Find the next active cell of each ray.
/// \return one bit for each ray that has one
std::uint64_t FindActive(const WalkScene& scene, RayWalks& walks)
{
  const Doubles d;
  std::uint64_t all = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(walks.Rays.Count); i += hn::Lanes(d))
  {
    WalkVector vector(scene, walks.Rays, i);
    Resume(walks, i, vector);
    M found = hn::Lt(hn::Zero(d), hn::Zero(d));
    vector.Walk(
      [&](M isActive) HWY_ATTR
      {
        found = hn::Or(found, isActive);
        return isActive;
      });
    all |= BitsOfMask(found) << i;
    StoreCells(vector, i, walks);
  }
  return all;
}

/// Append the cells of some lanes to the lists of their rays.
/// \param first ray of the vector
/// \return one bit for each lane whose list is full now
HWY_INLINE std::uint64_t AppendCells(
  const WalkVector& vector, std::uint64_t lanes, std::size_t first, NextCells& next)
{
  double cell[3][WidestVector / 2];
  for (std::size_t a = 0; a < 3; ++a)
  {
    hn::StoreU(vector.CellOf(a), Doubles(), cell[a]);
  }
  std::uint64_t full = 0;
  for (std::uint64_t left = lanes; left != 0; left &= left - 1)
  {
    const std::size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero64(left);
    std::int32_t& count = next.Count[first + lane];
    for (std::size_t a = 0; a < 3; ++a)
    {
      next.Cell[static_cast<std::size_t>(count)][a][first + lane] = cell[a][lane];
    }
    ++count;
    full |= static_cast<std::uint64_t>(count == NextCells::Most) << lane;
  }
  return full;
}

void ListActive(const WalkScene& scene, RayWalks& walks, NextCells& next)
{
  const Doubles d;
  for (std::size_t i = 0; i < static_cast<std::size_t>(walks.Rays.Count); i += hn::Lanes(d))
  {
    WalkVector vector(scene, walks.Rays, i);
    Resume(walks, i, vector);
    vector.Walk(
      [&](M isActive) HWY_ATTR
      {
        const std::uint64_t full = AppendCells(vector, BitsOfMask(isActive), i, next);
        std::uint8_t bits[8] = { static_cast<std::uint8_t>(full) };
        return hn::LoadMaskBits(d, bits);
      });
    StoreCells(vector, i, walks);
  }
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(FindActive);
HWY_EXPORT(ListActive);

RayWalks::RayWalks(const RayBatch& rays, std::uint64_t which)
{
  if (which == ~std::uint64_t(0))
  {
    this->Rays = rays;
    std::iota(this->From.begin(), this->From.end(), std::int64_t(0));
    return;
  }
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
  {
    if (which >> ray & 1u)
    {
      this->From[static_cast<std::size_t>(this->Rays.Count)] = static_cast<std::int64_t>(ray);
      AppendRay(rays, ray, this->Rays);
    }
  }
}

void KeepRays(std::uint64_t which, RayWalks& walks)
{
  RayBatch& rays = walks.Rays;
  const auto before = static_cast<std::size_t>(rays.Count);
  std::size_t count = 0;
  RayBatch::Array<std::uint8_t> kept;
  for (std::size_t i = 0; i < before; ++i)
  {
    kept[count] = static_cast<std::uint8_t>(i);
    count += which >> i & 1u;
  }
  rays.Count = static_cast<int>(count);
  if (count == 0 || count == RayBatch::Capacity)
  {
    return;
  }
  // Kernels need valid numbers up to the end of the last vector.
  std::fill(&kept[count], kept.data() + WholeVectors(count), kept[count - 1]);
  count = WholeVectors(count);
  // Rays before the first dropped ray keep their places.
  const std::size_t first = hwy::Num0BitsBelowLS1Bit_Nonzero64(~which);
  const auto keep = [&](auto& array)
  {
    for (std::size_t i = first; i < count; ++i)
    {
      array[i] = array[kept[i]];
    }
  };
  for (std::size_t a = 0; a < 3; ++a)
  {
    keep(rays.Origin[a]);
    keep(rays.Direction[a]);
    keep(rays.Inverse[a]);
    keep(walks.Cell[a]);
  }
  keep(rays.Begin);
  keep(rays.End);
  keep(rays.WalkEnd);
  keep(walks.From);
}

void FindActiveCells(const WalkScene& scene, RayWalks& walks)
{
  const std::uint64_t found = HWY_DYNAMIC_DISPATCH(FindActive)(scene, walks);
  walks.HasBegun = true;
  KeepRays(found, walks);
}

void ListActiveCells(const WalkScene& scene, RayWalks& walks, NextCells& next)
{
  next.Count.fill(0);
  walks.Distance.fill(std::numeric_limits<double>::infinity());
  HWY_DYNAMIC_DISPATCH(ListActive)(scene, walks, next);
  walks.HasBegun = true;
}

}
#endif
