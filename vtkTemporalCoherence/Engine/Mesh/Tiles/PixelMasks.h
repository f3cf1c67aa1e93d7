// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PixelMasks_h
#define TemporalCoherence_PixelMasks_h

#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// A hull is an outline with 16 edges: bounds of its pixels along these directions and against
/// them. Along each direction, pixels have whole numbers.
constexpr std::size_t Directions = 8;
constexpr std::size_t SidesOfHull = 2 * Directions;
constexpr int StepsX[Directions] = { 1, 0, 1, 1, 2, 2, 1, 1 };
constexpr int StepsY[Directions] = { 0, 1, 1, -1, 1, -1, 2, -2 };

/// The pixels of a tile up to each whole number along a side.
struct PixelsUpTo
{
  static constexpr int Numbers = 32;

  constexpr PixelsUpTo()
  {
    for (std::size_t side = 0; side < SidesOfHull; ++side)
    {
      const int sign = side < Directions ? 1 : -1;
      const int x = sign * StepsX[side % Directions], y = sign * StepsY[side % Directions];
      const int least = 7 * ((x < 0 ? x : 0) + (y < 0 ? y : 0));
      this->PerColumn[side] = static_cast<float>(x);
      this->Add[side] = static_cast<float>(1 - least);
      for (int pixel = 0; pixel < 64; ++pixel)
      {
        for (int number = pixel % 8 * x + pixel / 8 * y + 1 - least; number < Numbers; ++number)
        {
          this->Masks[side][number] |= std::uint64_t(1) << pixel;
        }
      }
    }
  }

  /// [side][number]: pixels below number - Add along the side.
  std::uint64_t Masks[SidesOfHull][Numbers] = {};
  alignas(64) float PerColumn[SidesOfHull] = {};
  alignas(64) float Add[SidesOfHull] = {};
};

inline constexpr PixelsUpTo Pixels;

struct ColumnsAndRows
{
  constexpr ColumnsAndRows()
  {
    for (int pixel = 0; pixel < 64; ++pixel)
    {
      this->Column[pixel] = static_cast<float>(pixel % 8);
      this->Row[pixel] = static_cast<float>(pixel / 8);
    }
  }
  alignas(64) float Column[64] = {}, Row[64] = {};
};

/// Columns and rows of a tile's pixels.
inline constexpr ColumnsAndRows Places;

}

#endif
