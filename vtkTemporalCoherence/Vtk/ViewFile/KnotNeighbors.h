// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KnotNeighbors_h
#define TemporalCoherence_KnotNeighbors_h

#include "Isomap/KnotImage.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace TemporalCoherence
{

/// Distance and octahedral coordinates of a knot, or between knots.
struct KnotValues
{
  std::int64_t Distance = 0;
  std::array<int, 2> Normal{};
};

/// The knots of a pixel beside the one that is encoded or decoded. Asked for by ascending progress.
class KnotNeighbor
{
public:
  KnotNeighbor() = default;
  KnotNeighbor(const PixelKnots& knots, std::size_t pixel)
    : Knots(&knots)
    , Next(knots.Begin[pixel])
    , At(Next)
    , Begin(Next)
    , End(knots.Begin[pixel + 1])
  {
  }

  /// The first progress above `last`; -1 if there is none.
  int ProgressAbove(int last)
  {
    while (this->Next < this->End && this->Knots->Progress[this->Next] <= last)
    {
      ++this->Next;
    }
    return this->Next < this->End ? this->Knots->Progress[this->Next] : -1;
  }

  /// The fit at a progress.
  /// \param isBehindJump of two knots with this progress, take the second one
  /// \return false if the fit does not reach from before the progress to behind it
  bool FitAt(int progress, bool isBehindJump, KnotValues& values)
  {
    if (this->Begin == this->End || progress < this->Knots->Progress[this->Begin])
    {
      return false;
    }
    while (this->At < this->End && this->Knots->Progress[this->At] < progress)
    {
      ++this->At;
    }
    if (this->At == this->End)
    {
      return false;
    }
    std::size_t knot = this->At;
    if (this->Knots->Progress[knot] == progress)
    {
      while (isBehindJump && knot + 1 < this->End && this->Knots->Progress[knot + 1] == progress)
      {
        ++knot;
      }
      values = this->ValuesOf(knot);
      return true;
    }
    const KnotValues before = this->ValuesOf(knot - 1), behind = this->ValuesOf(knot);
    const std::int64_t from = this->Knots->Progress[knot - 1];
    const std::int64_t gained = this->Knots->Progress[knot] - from, share = progress - from;
    const auto between = [&](std::int64_t a, std::int64_t b)
    { return a + FloorOf((b - a) * share, gained); };
    values.Distance = between(before.Distance, behind.Distance);
    for (std::size_t c = 0; c < 2; ++c)
    {
      values.Normal[c] = static_cast<int>(between(before.Normal[c], behind.Normal[c]));
    }
    return true;
  }

  static std::int64_t FloorOf(std::int64_t dividend, std::int64_t divisor)
  {
    return dividend / divisor - (dividend % divisor < 0 ? 1 : 0);
  }

private:
  KnotValues ValuesOf(std::size_t knot) const
  {
    const OctahedralNormal& normal = this->Knots->Normals[knot];
    return { static_cast<std::int64_t>(this->Knots->Distance[knot]), { normal[0], normal[1] } };
  }

  const PixelKnots* Knots = nullptr;
  std::size_t Next = 0, At = 0, Begin = 0, End = 0;
};

/// What the neighbours of a pixel, and its own last knot, let expect of its next knot.
class KnotNeighbors
{
public:
  /// How the progress of a knot is told.
  enum Token : std::uint8_t
  {
    AsLeft,  ///< that of the next knot of the pixel to the left
    AsBelow, ///< that of the next knot of the pixel below
    Jump,    ///< that of the last knot
    Told     ///< by its difference from what ProgressExpected() gives
  };

  /// \param pixel of `width` in a row
  /// \param first pixel of the chunk: it knows nothing of those before
  KnotNeighbors(const PixelKnots& knots, std::size_t pixel, std::size_t width, std::size_t first)
  {
    const bool hasLeft = pixel % width > 0, hasBelow = pixel >= first + width;
    this->Left = hasLeft ? KnotNeighbor(knots, pixel - 1) : KnotNeighbor();
    this->Below = hasBelow ? KnotNeighbor(knots, pixel - width) : KnotNeighbor();
    this->Diagonal = hasLeft && hasBelow ? KnotNeighbor(knots, pixel - width - 1) : KnotNeighbor();
  }

  /// The next progress of each neighbour, or -1.
  int NextOfLeft() { return this->Left.ProgressAbove(this->Last); }
  int NextOfBelow() { return this->Below.ProgressAbove(this->Last); }
  int LastProgress() const { return this->Last; }

  int ProgressExpected()
  {
    const int left = this->NextOfLeft();
    const int next = left >= 0 ? left : this->NextOfBelow();
    return next >= 0 ? next : std::max(this->Last, 0);
  }

  /// Ask the neighbours for a progress.
  void GoTo(int progress)
  {
    const bool isBehindJump = progress == this->Last;
    this->HasLeft = this->Left.FitAt(progress, isBehindJump, this->OfLeft);
    this->HasBelow = this->Below.FitAt(progress, isBehindJump, this->OfBelow);
    this->HasDiagonal = this->Diagonal.FitAt(progress, isBehindJump, this->OfDiagonal);
  }

  std::int64_t DistanceExpected() const
  {
    const std::int64_t left = this->OfLeft.Distance, below = this->OfBelow.Distance;
    if (this->HasLeft && this->HasBelow && this->HasDiagonal)
    {
      const std::int64_t low = std::min(left, below), high = std::max(left, below);
      const std::int64_t diagonal = this->OfDiagonal.Distance;
      return diagonal >= high ? low : diagonal <= low ? high : left + below - diagonal;
    }
    constexpr std::int64_t usualStep = 8;
    return this->HasLeft ? left
      : this->HasBelow   ? below
      : this->Last >= 0  ? this->LastValues.Distance + usualStep
                         : 0;
  }

  std::array<int, 2> NormalExpected(std::int64_t distance) const
  {
    constexpr std::int64_t close = 40;
    const bool takesLeft = this->HasLeft && std::abs(this->OfLeft.Distance - distance) < close;
    const bool takesBelow = this->HasBelow && std::abs(this->OfBelow.Distance - distance) < close;
    return takesLeft && takesBelow ? MeanOf(this->OfLeft.Normal, this->OfBelow.Normal)
      : takesLeft                  ? this->OfLeft.Normal
      : takesBelow                 ? this->OfBelow.Normal
      : this->Last >= 0            ? this->LastValues.Normal
                                   : std::array<int, 2>{};
  }

  /// The normal half way from the last knot to one with this progress and normal.
  std::array<int, 2> MiddleExpected(int progress, const OctahedralNormal& normal) const
  {
    const std::array<int, 2> own = { normal[0], normal[1] };
    return progress > this->Last && this->Last >= 0 ? MeanOf(this->LastValues.Normal, own) : own;
  }

  /// Go on behind a knot.
  void Take(int progress, std::int64_t distance, const OctahedralNormal& normal)
  {
    this->Last = progress;
    this->LastValues = { distance, { normal[0], normal[1] } };
  }

private:
  static std::array<int, 2> MeanOf(const std::array<int, 2>& a, const std::array<int, 2>& b)
  {
    return { static_cast<int>(KnotNeighbor::FloorOf(a[0] + b[0], 2)),
      static_cast<int>(KnotNeighbor::FloorOf(a[1] + b[1], 2)) };
  }

  KnotNeighbor Left, Below, Diagonal;
  KnotValues OfLeft, OfBelow, OfDiagonal, LastValues;
  bool HasLeft = false, HasBelow = false, HasDiagonal = false;
  int Last = -1;
};

}

#endif
