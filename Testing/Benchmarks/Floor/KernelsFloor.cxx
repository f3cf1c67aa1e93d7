// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "KernelsFloor.h"

#include <cstring>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "KernelsFloor.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace FloorKernel
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;
using DI = hn::RebindToSigned<D>;
using V = hn::Vec<D>;
using I = hn::Vec<DI>;

HWY_INLINE V Set(float value)
{
  return hn::Set(D(), value);
}

HWY_INLINE V Mix(V a, V b, V weightOfB)
{
  return hn::MulAdd(weightOfB, hn::Sub(b, a), a);
}

HWY_INLINE V Dot(const V a[3], const V b[3])
{
  return hn::MulAdd(a[0], b[0], hn::MulAdd(a[1], b[1], hn::Mul(a[2], b[2])));
}

/// Four samples of a row along x, from the one before the cell on; two of them, those of the cell.
/// \param at number of the first sample
template <typename T>
HWY_INLINE void LoadRow(const T* samples, I at, V row[4])
{
  const DI d;
  const auto words = [&](std::size_t from) HWY_ATTR
  {
    const auto* base = reinterpret_cast<const std::int32_t*>(samples + from);
    return hn::GatherOffset(d, base, hn::Mul(at, hn::Set(d, static_cast<int>(sizeof(T)))));
  };
  if constexpr (sizeof(T) == 4)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      row[i] = hn::BitCast(D(), words(i));
    }
  }
  else if constexpr (sizeof(T) == 2)
  {
    const I low = words(0), high = words(2);
    row[0] = hn::ConvertTo(D(), hn::ShiftRight<16>(hn::ShiftLeft<16>(low)));
    row[1] = hn::ConvertTo(D(), hn::ShiftRight<16>(low));
    row[2] = hn::ConvertTo(D(), hn::ShiftRight<16>(hn::ShiftLeft<16>(high)));
    row[3] = hn::ConvertTo(D(), hn::ShiftRight<16>(high));
  }
  else
  {
    const I all = words(0), byte = hn::Set(d, 255);
    row[0] = hn::ConvertTo(D(), hn::And(all, byte));
    row[1] = hn::ConvertTo(D(), hn::And(hn::ShiftRight<8>(all), byte));
    row[2] = hn::ConvertTo(D(), hn::And(hn::ShiftRight<16>(all), byte));
    row[3] = hn::ConvertTo(D(), hn::And(hn::ShiftRight<24>(all), byte));
  }
}

/// The samples of a row of the cell alone.
template <typename T>
HWY_INLINE void LoadPair(const T* samples, I at, V pair[2])
{
  const DI d;
  if constexpr (sizeof(T) == 2)
  {
    const auto* base = reinterpret_cast<const std::int32_t*>(samples + 1);
    const I both = hn::GatherOffset(d, base, hn::Add(at, at));
    pair[0] = hn::ConvertTo(D(), hn::ShiftRight<16>(hn::ShiftLeft<16>(both)));
    pair[1] = hn::ConvertTo(D(), hn::ShiftRight<16>(both));
  }
  else if constexpr (sizeof(T) == 4)
  {
    const auto* base = reinterpret_cast<const std::int32_t*>(samples + 1);
    const I bytes = hn::ShiftLeft<2>(at);
    pair[0] = hn::BitCast(D(), hn::GatherOffset(d, base, bytes));
    pair[1] = hn::BitCast(D(), hn::GatherOffset(d, base + 1, bytes));
  }
  else
  {
    V row[4];
    LoadRow(samples, at, row);
    pair[0] = row[1];
    pair[1] = row[2];
  }
}

/// The root of the cubic from `begin` on, as a share of the step: three steps of Newton's method.
HWY_INLINE V FindRoot(const V corners[8], const V begin[3], const V step[3])
{
  // Powers of the share: linear along x, quadratic along x and y, then cubic.
  V line0[4], line1[4], square0[2], square1[2], square2[2];
  for (int row = 0; row < 4; ++row)
  {
    const V slope = hn::Sub(corners[2 * row + 1], corners[2 * row]);
    line0[row] = hn::MulAdd(slope, begin[0], corners[2 * row]);
    line1[row] = hn::Mul(slope, step[0]);
  }
  for (int z = 0; z < 2; ++z)
  {
    const V rise0 = hn::Sub(line0[2 * z + 1], line0[2 * z]);
    const V rise1 = hn::Sub(line1[2 * z + 1], line1[2 * z]);
    square0[z] = hn::MulAdd(begin[1], rise0, line0[2 * z]);
    square1[z] = hn::MulAdd(step[1], rise0, hn::MulAdd(begin[1], rise1, line1[2 * z]));
    square2[z] = hn::Mul(step[1], rise1);
  }
  const V rise0 = hn::Sub(square0[1], square0[0]), rise1 = hn::Sub(square1[1], square1[0]);
  const V rise2 = hn::Sub(square2[1], square2[0]);
  const V c0 = hn::MulAdd(begin[2], rise0, square0[0]);
  const V c1 = hn::MulAdd(step[2], rise0, hn::MulAdd(begin[2], rise1, square1[0]));
  const V c2 = hn::MulAdd(step[2], rise1, hn::MulAdd(begin[2], rise2, square2[0]));
  const V c3 = hn::Mul(step[2], rise2);
  const V zero = hn::Zero(D()), one = Set(1.0f);
  V s = hn::Div(c0, hn::Neg(hn::Add(c1, hn::Add(c2, c3))));
  for (int newton = 0; newton < 3; ++newton)
  {
    s = hn::Min(hn::Max(s, zero), one);
    const V value = hn::MulAdd(hn::MulAdd(hn::MulAdd(c3, s, c2), s, c1), s, c0);
    const V slope = hn::MulAdd(hn::MulAdd(hn::Mul(Set(3.0f), c3), s, hn::Add(c2, c2)), s, c1);
    s = hn::Sub(s, hn::Div(value, slope));
  }
  return hn::Min(hn::Max(s, zero), one);
}

/// Central differences at the corners of cells, mixed at a point.
/// \param along the rows of the cell: [y + 2 z]
template <typename T>
HWY_INLINE void FindGradient(const Picture& picture, const T* samples, I at, const V along[4][4],
  const V point[3], V gradient[3])
{
  const DI d;
  const auto mixed = [&](const V row[2]) HWY_ATTR { return Mix(row[0], row[1], point[0]); };
  const auto beside = [&](int y, int z) HWY_ATTR
  {
    V pair[2];
    LoadPair(samples, hn::Add(at, hn::Set(d, y * picture.StrideY + z * picture.StrideZ)), pair);
    return mixed(pair);
  };
  V centre[4], ahead[4];
  for (int row = 0; row < 4; ++row)
  {
    centre[row] = mixed(along[row] + 1);
    ahead[row] =
      Mix(hn::Sub(along[row][2], along[row][0]), hn::Sub(along[row][3], along[row][1]), point[0]);
  }
  const auto across = [&](const V edges[4]) HWY_ATTR
  { return Mix(Mix(edges[0], edges[1], point[1]), Mix(edges[2], edges[3], point[1]), point[2]); };
  gradient[0] = across(ahead);
  const V inY[4] = { hn::Sub(centre[1], beside(-1, 0)), hn::Sub(beside(2, 0), centre[0]),
    hn::Sub(centre[3], beside(-1, 1)), hn::Sub(beside(2, 1), centre[2]) };
  gradient[1] = across(inY);
  const V inZ[4] = { hn::Sub(centre[2], beside(0, -1)), hn::Sub(centre[3], beside(1, -1)),
    hn::Sub(beside(0, 2), centre[0]), hn::Sub(beside(1, 2), centre[1]) };
  gradient[2] = across(inZ);
}

/// Phong's colour under a headlight, as RGBA.
HWY_INLINE I Shade(const Picture& picture, const V gradient[3], const V direction[3])
{
  const V length = hn::Mul(Dot(gradient, gradient), Dot(direction, direction));
  const V perLength = hn::Div(Set(1.0f), hn::Sqrt(hn::Max(length, Set(1e-20f))));
  const V cosine = hn::Abs(hn::Mul(Dot(gradient, direction), perLength));
  const V mirrored = hn::Max(hn::MulSub(hn::Add(cosine, cosine), cosine, Set(1.0f)), hn::Zero(D()));
  const V square = hn::Mul(mirrored, mirrored), fourth = hn::Mul(square, square);
  const V shine = hn::Mul(Set(picture.Specular), hn::Mul(hn::Mul(fourth, fourth), square));
  const V matt = hn::MulAdd(Set(picture.Diffuse), cosine, Set(picture.Ambient));
  const DI d;
  I color = hn::Set(d, static_cast<int>(0xff000000u));
  const auto add = [&](std::size_t channel) HWY_ATTR
  {
    const V sum = hn::Min(hn::MulAdd(Set(picture.Color[channel]), matt, shine), Set(1.0f));
    return hn::NearestInt(hn::Mul(sum, Set(255.0f)));
  };
  color = hn::Or(color, add(0));
  color = hn::Or(color, hn::ShiftLeft<8>(add(1)));
  return hn::Or(color, hn::ShiftLeft<16>(add(2)));
}

template <typename T>
HWY_INLINE void Draw(const Picture& picture, const Tile& tile)
{
  const D d;
  const DI di;
  const T* const before = static_cast<const T*>(picture.Samples) - 1;
  const V zero = hn::Zero(d), one = Set(1.0f);
  HWY_ALIGN float depths[TilePixels] = {};
  HWY_ALIGN std::int32_t colors[TilePixels] = {};
  for (std::size_t i = 0; i < TilePixels && tile.Hits != 0; i += hn::Lanes(d))
  {
    const I pixel = hn::Iota(di, static_cast<int>(i));
    const V x = hn::ConvertTo(d, hn::Add(hn::And(pixel, hn::Set(di, 7)), hn::Set(di, tile.FirstX)));
    const V y = hn::ConvertTo(d, hn::Add(hn::ShiftRight<3>(pixel), hn::Set(di, tile.FirstY)));
    V direction[3], begin[3], step[3], point[3], corners[8], along[4][4], gradient[3];
    V enter = zero, leave = Set(1e30f);
    I at = hn::LoadU(di, &tile.Cell[0][i]);
    at = hn::Add(at, hn::Mul(hn::LoadU(di, &tile.Cell[1][i]), hn::Set(di, picture.StrideY)));
    at = hn::Add(at, hn::Mul(hn::LoadU(di, &tile.Cell[2][i]), hn::Set(di, picture.StrideZ)));
    for (std::size_t a = 0; a < 3; ++a)
    {
      direction[a] = hn::MulAdd(x, Set(picture.DirectionX[a]),
        hn::MulAdd(y, Set(picture.DirectionY[a]), Set(picture.Direction[a])));
      const V cell = hn::ConvertTo(d, hn::LoadU(di, &tile.Cell[a][i]));
      begin[a] = hn::Sub(Set(picture.Origin[a]), cell);
      const V inverse = hn::Div(one, direction[a]);
      const V toLow = hn::Neg(hn::Mul(begin[a], inverse));
      const V toHigh = hn::Add(toLow, inverse);
      enter = hn::Max(enter, hn::Min(toLow, toHigh));
      leave = hn::Min(leave, hn::Max(toLow, toHigh));
    }
    const V length = hn::Sub(leave, enter);
    for (std::size_t a = 0; a < 3; ++a)
    {
      begin[a] = hn::MulAdd(enter, direction[a], begin[a]);
      step[a] = hn::Mul(length, direction[a]);
    }
    for (int row = 0; row < 4; ++row)
    {
      const int offset = (row & 1) * picture.StrideY + (row >> 1) * picture.StrideZ;
      LoadRow(before, hn::Add(at, hn::Set(di, offset)), along[row]);
      corners[2 * row] = hn::Sub(along[row][1], Set(picture.Isovalue));
      corners[2 * row + 1] = hn::Sub(along[row][2], Set(picture.Isovalue));
    }
    const V share = FindRoot(corners, begin, step);
    for (std::size_t a = 0; a < 3; ++a)
    {
      point[a] = hn::MulAdd(share, step[a], begin[a]);
    }
    FindGradient(picture, before, at, along, point, gradient);
    hn::Store(hn::MulAdd(share, length, enter), d, depths + i);
    hn::Store(Shade(picture, gradient, direction), di, colors + i);
  }
  for (std::size_t i = 0; i < TilePixels && ~tile.Hits != 0; ++i)
  {
    const bool isHit = tile.Hits >> i & 1;
    depths[i] = isHit ? depths[i] : 1.0f;
    colors[i] = isHit ? colors[i] : 0;
  }
  for (std::size_t row = 0; row < 8; ++row)
  {
    const std::size_t to =
      (static_cast<std::size_t>(tile.FirstY) + row) * static_cast<std::size_t>(picture.Width) +
      static_cast<std::size_t>(tile.FirstX);
    std::memcpy(picture.Depth + to, depths + 8 * row, 8 * sizeof(float));
    std::memcpy(picture.Colors + to, colors + 8 * row, 8 * sizeof(std::int32_t));
  }
}

void DrawBytes(const Picture& picture, const Tile& tile)
{
  Draw<std::uint8_t>(picture, tile);
}
void DrawShorts(const Picture& picture, const Tile& tile)
{
  Draw<std::int16_t>(picture, tile);
}
void DrawFloats(const Picture& picture, const Tile& tile)
{
  Draw<float>(picture, tile);
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace FloorKernel
{

HWY_EXPORT(DrawBytes);
HWY_EXPORT(DrawShorts);
HWY_EXPORT(DrawFloats);

void DrawTile(const Picture& picture, const Tile& tile, std::uint8_t)
{
  HWY_DYNAMIC_DISPATCH(DrawBytes)(picture, tile);
}

void DrawTile(const Picture& picture, const Tile& tile, std::int16_t)
{
  HWY_DYNAMIC_DISPATCH(DrawShorts)(picture, tile);
}

void DrawTile(const Picture& picture, const Tile& tile, float)
{
  HWY_DYNAMIC_DISPATCH(DrawFloats)(picture, tile);
}

}
#endif
