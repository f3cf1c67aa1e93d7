// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/KernelsRays.h"

#include "Scene/Tiles.h"

#include <array>

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Lattice/KernelsRays.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, WidestVector / 2>;
using V = hn::Vec<Doubles>;

/// A direction component smaller than this share of the largest one is raised to it, keeping its
/// sign, so that its inverse is finite. Over the 1e4 cells of a large volume the ray strays by
/// 1e-11 cells.
constexpr double SmallestShare = 1e-15;

/// Normalised device coordinates of the columns and rows of pixels. Unused places repeat the first
/// coordinate.
struct PixelCentres
{
  PixelCentres(const RaySource& source, const glm::ivec2& first, const glm::ivec2& size)
  {
    for (int i = 0; i < TileSize; ++i)
    {
      const int column = i < size.x ? i : 0, row = i < size.y ? i : 0;
      const auto at = static_cast<std::size_t>(i);
      this->X[at] = (2.0 * (first.x + column) + 1.0) / source.Size.x - 1.0;
      this->Y[at] = (2.0 * (first.y + row) + 1.0) / source.Size.y - 1.0;
    }
  }

  std::array<double, TileSize> X, Y;
};

/// A component of a linear vector.
HWY_INLINE V At(const RaySource::LinearVector& vector, int axis, V x, V y)
{
  const Doubles d;
  const V centre = hn::Set(d, vector[0][axis]);
  const V perX = hn::Set(d, vector[1][axis]), perY = hn::Set(d, vector[2][axis]);
  return hn::Add(hn::Add(centre, hn::Mul(x, perX)), hn::Mul(y, perY));
}

/// Set up a vector of rays, from their normalised device coordinates.
HWY_INLINE void SetUpVector(
  const RaySource& source, V x, V y, std::size_t i, RayBatch& rays, WorldDirections* world)
{
  const Doubles d;
  const V one = hn::Set(d, 1.0), zero = hn::Zero(d);
  const V wx = At(source.World, 0, x, y), wy = At(source.World, 1, x, y);
  const V wz = At(source.World, 2, x, y);
  const V length = hn::Sqrt(hn::Add(hn::Add(hn::Mul(wx, wx), hn::Mul(wy, wy)), hn::Mul(wz, wz)));
  const V forward =
    hn::Add(hn::Add(hn::Set(d, source.Forward.x), hn::Mul(x, hn::Set(d, source.Forward.y))),
      hn::Mul(y, hn::Set(d, source.Forward.z)));
  // A user's transform may make planes of one depth oblique to the optical axis. Rays are affine in
  // the pixel where they come to such a plane, but not where they come to a clipping plane.
  const V perForward = hn::Div(length, forward);
  V begin = hn::Mul(hn::Set(d, source.Near), perForward);
  V end = hn::Mul(hn::Set(d, source.Far), perForward);

  const V perLength = hn::Div(one, length);
  if (world)
  {
    hn::StoreU(hn::Mul(wx, perLength), d, &(*world)[0][i]);
    hn::StoreU(hn::Mul(wy, perLength), d, &(*world)[1][i]);
    hn::StoreU(hn::Mul(wz, perLength), d, &(*world)[2][i]);
  }
  V direction[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    direction[axis] = hn::Mul(At(source.Direction, axis, x, y), perLength);
  }
  const V largest =
    hn::Max(hn::Abs(direction[0]), hn::Max(hn::Abs(direction[1]), hn::Abs(direction[2])));
  const V smallest = hn::Mul(hn::Set(d, SmallestShare), largest);
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    const V least = hn::CopySign(smallest, direction[a]);
    const V along = hn::IfThenElse(hn::Lt(hn::Abs(direction[a]), smallest), least, direction[a]);
    const V inverse = hn::Div(one, along);
    const V origin = At(source.Origin, axis, x, y);
    // The planes of the box are the faces of its first and last cells.
    const V toFirst = hn::Mul(hn::Sub(zero, origin), inverse);
    const V toLast = hn::Mul(hn::Sub(hn::Set(d, source.Last[axis]), origin), inverse);
    begin = hn::Max(begin, hn::Min(toFirst, toLast));
    end = hn::Min(end, hn::Max(toFirst, toLast));
    hn::StoreU(origin, d, &rays.Origin[a][i]);
    hn::StoreU(along, d, &rays.Direction[a][i]);
    hn::StoreU(inverse, d, &rays.Inverse[a][i]);
  }
  hn::StoreU(length, d, &rays.PerDepth[i]);
  hn::StoreU(begin, d, &rays.Begin[i]);
  hn::StoreU(begin, d, &rays.WalkBegin[i]);
  hn::StoreU(end, d, &rays.End[i]);
  hn::StoreU(end, d, &rays.WalkEnd[i]);
}

/// Set up a tile of whole rows.
HWY_INLINE void SetUpRows(const RaySource& source, const PixelCentres& centres, int rows,
  RayBatch& rays, WorldDirections* world)
{
  const Doubles d;
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row)
  {
    const V y = hn::Set(d, centres.Y[row]);
    for (std::size_t column = 0; column < TileSize; column += hn::Lanes(d))
    {
      SetUpVector(
        source, hn::LoadU(d, &centres.X[column]), y, row * TileSize + column, rays, world);
    }
  }
}

/// Set up a tile cut off by the picture's border: row by row, without gaps.
HWY_INLINE void SetUpPart(const RaySource& source, const PixelCentres& centres,
  const glm::ivec2& size, RayBatch& rays, WorldDirections* world)
{
  const Doubles d;
  RayBatch::Array<double> x, y;
  x.fill(centres.X[0]);
  y.fill(centres.Y[0]);
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    x[i] = centres.X[i % static_cast<std::size_t>(size.x)];
    y[i] = centres.Y[i / static_cast<std::size_t>(size.x)];
  }
  for (std::size_t i = 0; i < WholeVectors(static_cast<std::size_t>(rays.Count)); i += hn::Lanes(d))
  {
    SetUpVector(source, hn::LoadU(d, &x[i]), hn::LoadU(d, &y[i]), i, rays, world);
  }
}

void SetUp(const RaySource& source, const glm::ivec2& first, const glm::ivec2& size, RayBatch& rays,
  WorldDirections* world)
{
  rays.Count = size.x * size.y;
  std::size_t ray = 0;
  for (int row = 0; row < size.y; ++row)
  {
    const std::int32_t pixel = (first.y + row) * source.Size.x + first.x;
    if (size.x == TileSize)
    {
      for (int column = 0; column < TileSize; ++column) // in vectors
      {
        rays.Pixel[ray + static_cast<std::size_t>(column)] = pixel + column;
      }
      ray += TileSize;
      continue;
    }
    for (int column = 0; column < size.x; ++column)
    {
      rays.Pixel[ray++] = pixel + column;
    }
  }
  const PixelCentres centres(source, first, size);
  // Whole vectors of the widest kind, as all kernels expect them.
  if (size.x == TileSize && size.y % 2 == 0)
  {
    SetUpRows(source, centres, size.y, rays, world);
    return;
  }
  SetUpPart(source, centres, size, rays, world);
}

void SetUpAt(const RaySource& source, const RayPlaces& at, RayBatch& rays, WorldDirections* world)
{
  const Doubles d;
  for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(d))
  {
    SetUpVector(source, hn::LoadU(d, &at.X[i]), hn::LoadU(d, &at.Y[i]), i, rays, world);
  }
}

/// One bit for each lane of a vector that begins at lane `i` of 64.
template <class D>
HWY_INLINE std::uint64_t BitsAt(D d, hn::Mask<D> mask, std::size_t i)
{
  std::uint8_t bits[8] = { 0 };
  hn::StoreMaskBits(d, mask, bits);
  return (static_cast<std::uint64_t>(bits[0]) | static_cast<std::uint64_t>(bits[1]) << 8) << i;
}

std::uint64_t FindWalks(const RayBatch& rays, const HitBatch& hits)
{
  const Doubles d;
  const hn::CappedTag<std::uint8_t, WidestVector> dk;
  const std::size_t count = static_cast<std::size_t>(rays.Count), end = WholeVectors(count);
  std::uint64_t haveWalk = 0, haveNoHit = 0;
  for (std::size_t i = 0; i < end; i += hn::Lanes(d))
  {
    const auto begin = hn::LoadU(d, &rays.Begin[i]), walkBegin = hn::LoadU(d, &rays.WalkBegin[i]);
    const auto isRay = hn::Lt(begin, hn::LoadU(d, &rays.End[i]));
    const auto isWalk = hn::Lt(walkBegin, hn::LoadU(d, &rays.WalkEnd[i]));
    haveWalk |= BitsAt(d, hn::And(isRay, isWalk), i);
  }
  const auto none = hn::Set(dk, static_cast<std::uint8_t>(HitKind::None));
  for (std::size_t i = 0; i < end; i += hn::Lanes(dk))
  {
    const auto* const kinds = reinterpret_cast<const std::uint8_t*>(hits.Kind.data());
    haveNoHit |= BitsAt(dk, hn::Eq(hn::LoadU(dk, kinds + i), none), i);
  }
  const std::uint64_t all =
    count < RayBatch::Capacity ? (std::uint64_t(1) << count) - 1 : ~std::uint64_t(0);
  return haveWalk & haveNoHit & all;
}

void FindCells(const RayBatch& rays, const glm::ivec3& count, CellsOfRays& cells)
{
  const Doubles d;
  const hn::Rebind<std::int32_t, Doubles> di;
  const V zero = hn::Zero(d);
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); i += hn::Lanes(d))
  {
    const V begin = hn::LoadU(d, &rays.Begin[i]);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V last = hn::Set(d, count[static_cast<int>(a)] - 1.0);
      const V along = hn::Mul(begin, hn::LoadU(d, &rays.Direction[a][i]));
      const V at = hn::Add(hn::LoadU(d, &rays.Origin[a][i]), along);
      const V raised = hn::IfThenElse(hn::Gt(at, zero), at, zero);
      const V inside = hn::IfThenElse(hn::Lt(raised, last), raised, last);
      hn::StoreU(hn::DemoteTo(di, inside), di, &cells[a][i]);
    }
  }
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(SetUp);
HWY_EXPORT(SetUpAt);
HWY_EXPORT(FindWalks);
HWY_EXPORT(FindCells);

void SetUpRays(const RaySource& source, const glm::ivec2& first, const glm::ivec2& size,
  RayBatch& rays, WorldDirections* world)
{
  HWY_DYNAMIC_DISPATCH(SetUp)(source, first, size, rays, world);
}

void SetUpRaysAt(
  const RaySource& source, const RayPlaces& at, RayBatch& rays, WorldDirections* world)
{
  HWY_DYNAMIC_DISPATCH(SetUpAt)(source, at, rays, world);
}

std::uint64_t WalksWithoutHit(const RayBatch& rays, const HitBatch& hits)
{
  return HWY_DYNAMIC_DISPATCH(FindWalks)(rays, hits);
}

void FindFirstCells(const RayBatch& rays, const glm::ivec3& count, CellsOfRays& cells)
{
  HWY_DYNAMIC_DISPATCH(FindCells)(rays, count, cells);
}

}
#endif
