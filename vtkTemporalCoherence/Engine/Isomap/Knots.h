// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Knots_h
#define TemporalCoherence_Knots_h

#include "Isomap/KnotGrid.h"
#include "Isomap/RayTable.h"
#include "Scene/Difference.h"
#include "Scene/Surfaces.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include <hwy/cache_control.h>

namespace TemporalCoherence
{

/// The direction in which the field passes isovalues along a ray.
enum class ValueDirection : std::uint8_t
{
  Rising, ///< from below to above; isovalues in ascending order, from the band's lowest
  Falling ///< from above to below; isovalues in descending order, from the band's highest
};
constexpr std::size_t NumberOfDirections = 2;

/// Converts isovalues of a band to *progress* in a direction: 0 at the first isovalue of the band,
/// `Span` at the last. A ray that has reached progress p has passed all isovalues up to p.
struct BandScale
{
  /// \param samples     type of the field's samples
  /// \param finiteRange smallest and largest finite sample of the field
  BandScale(ScalarType samples, const ValueBand& band, const glm::dvec2& finiteRange)
    : Isovalues(IsovalueScale::For(samples, band, finiteRange))
    , Low(band.Low)
    , Span(this->DifferenceOf(band.High))
    , Unit(this->Isovalues.LargestFrom(band.Low, finiteRange) + this->Span)
  {
  }

  /// Difference of an isovalue of the band from its lowest one.
  double DifferenceOf(double isovalue) const
  {
    return this->Isovalues.Scaled(isovalue) - this->Isovalues.Scaled(this->Low);
  }

  /// Progress at a difference from the band's lowest isovalue.
  double Progress(ValueDirection direction, double difference) const
  {
    return direction == ValueDirection::Rising ? difference : this->Span - difference;
  }

  using Key = std::uint16_t;
  static constexpr double LargestKey = 65535.0;

  /// Progress as an integer, rounded up: 0 before the band, LargestKey behind it. Keys preserve
  /// order, so that a search for an isovalue's key never goes too far.
  Key KeyOf(double progress) const
  {
    if (!(progress >= 0.0))
    {
      return 0;
    }
    if (progress > this->Span)
    {
      return static_cast<Key>(LargestKey);
    }
    // Rounded up: a call of ceil() would take longer than the rest.
    const double at = this->Span > 0.0 ? progress / this->Span * (LargestKey - 2.0) : 0.0;
    const auto below = static_cast<std::int32_t>(at);
    return static_cast<Key>(1 + below + (static_cast<double>(below) < at ? 1 : 0));
  }

  /// The grid for fitted knots.
  /// \param tolerance       of distances
  /// \param largestProgress in steps
  KnotGrid GridFor(double tolerance, std::uint16_t largestProgress) const
  {
    const double steps = largestProgress - 2.0 * KnotGrid::Margin;
    const double step = std::max(this->Span / steps, StoredError * this->Unit);
    return { step > 0.0 ? step : 1.0, tolerance / KnotGrid::StepsOfTolerance, largestProgress };
  }

  /// Differences are stored in single precision, relative to the largest difference.
  /// StoredError is the resulting error.
  float Stored(double progress) const
  {
    return this->Unit > 0.0 ? static_cast<float>(progress / this->Unit) : 0.0f;
  }
  static constexpr double StoredError = 32.0 * std::numeric_limits<float>::epsilon();

  /// The same in steps of a grid.
  double ErrorIn(const KnotGrid& grid) const
  {
    return StoredError * this->Unit / grid.ProgressStep;
  }

  IsovalueScale Isovalues; ///< gives the unit of differences and progress
  double Low;              ///< lowest isovalue of the band
  double Span, Unit;
};

/// The cells that raise a ray's progress, in order along the ray. The ray crosses an isovalue in
/// the first cell whose key is at least the key of the isovalue.
///
/// Columns: key of the field along the ray up to the end of the cell, first corner of the cell.
using CellIndex = std::array<std::uint16_t, 3>;
using CellKnots = RayTable<BandScale::Key, CellIndex>;

/// The first of the ascending keys begin .. end - 1 that is at least `key`.
inline std::size_t FirstNotBelow(
  const BandScale::Key* keys, std::size_t begin, std::size_t end, BandScale::Key key)
{
  constexpr std::size_t FewKnots = 8;
  if (end - begin > FewKnots)
  {
    return static_cast<std::size_t>(std::lower_bound(keys + begin, keys + end, key) - keys);
  }
  while (begin < end && keys[begin] < key)
  {
    ++begin;
  }
  return begin;
}

/// Knots of a piecewise linear function from progress to the distance at which a ray first reaches
/// it, within a tolerance. Two knots with equal progress mark a jump.
///
/// Columns: distance from where the ray begins and progress, in steps of the grid.
using FittedKnots = RayTable<decltype(Knot::Distance), decltype(Knot::Progress)>;

/// The result of a look-up of a progress in fitted knots.
enum class FitAnswer : std::uint8_t
{
  Missed,     ///< the ray does not reach it
  Reached,    ///< the ray reaches it
  UnsureMiss, ///< the knots say that it is missed, but the end of the ray is close
  UnsureHit   ///< the knots say that it is reached, but it is steep there, or a jump is close
};

/// A point between knots.
struct FitPoint
{
  double Distance; ///< from where the ray begins, in steps
  std::size_t Before, Knot;
  float Share; ///< of the way from Before to Knot
};

/// The fitted knots of one ray: Begin to End - 1 in columns.
struct FittedRay
{
  const decltype(Knot::Distance)* Distance;
  const decltype(Knot::Progress)* Progress;
  std::size_t Begin, End;
};

/// Find where a ray reaches a progress.
/// \pre the ray has knots
/// \param progress in steps
/// \param error    of it, in steps
/// \param point    set if it is reached, also if that is unsure
FitAnswer FindInFit(const FittedRay& ray, double progress, double error, FitPoint& point);

/// Unit normals in the world, in units of 1 / LargestNormal, one for each knot, where the field has
/// the knot's progress. Fitted knots have two: behind each the normal half way in progress from the
/// knot before, as normals turn much along a piece.
using PackedNormal = std::array<std::int16_t, 3>;
using KnotNormals = RayTable<PackedNormal>;
constexpr float LargestNormal = 32767.0f;

/// A normal on a piece, by a parabola through those at its ends and half way: not normalised.
/// \param share of the way from `before` to `behind`
template <typename Vector, typename Real>
Vector NormalOnPiece(const Vector& before, const Vector& middle, const Vector& behind, Real share)
{
  const Real one(1), two(2), four(4);
  return (one - share) * (one - two * share) * before + four * share * (one - share) * middle +
    share * (two * share - one) * behind;
}

/// The knots of the rays of a tile for a band, in each direction.
struct TileKnots
{
  std::array<CellKnots, NumberOfDirections> Cells;     ///< for exact look-ups
  std::array<FittedKnots, NumberOfDirections> Fitted;  ///< for look-ups with a tolerance
  std::array<KnotNormals, NumberOfDirections> Normals; ///< of the knots, if they are wanted

  /// The field's difference from the band's lowest isovalue where each ray begins, as stored;
  /// -infinity below the band. Empty if all rays begin below the band.
  std::vector<float> Entries;
  static constexpr std::size_t RaysOfLine = 16; ///< entries in a cache line

  /// One bit for each ray that cannot be looked up, because it meets samples that are not finite.
  std::uint64_t Unresolved = 0;

  bool IsEmpty() const
  {
    const auto isEmpty = [](const auto& table) { return table.IsEmpty(); };
    return std::all_of(this->Cells.begin(), this->Cells.end(), isEmpty) &&
      std::all_of(this->Fitted.begin(), this->Fitted.end(), isEmpty) && this->Entries.empty() &&
      this->Unresolved == 0;
  }

  /// Prefetch the cells and entries.
  void Prefetch() const
  {
    for (const CellKnots& table : this->Cells)
    {
      table.Prefetch();
    }
    for (std::size_t ray = 0; ray < this->Entries.size(); ray += RaysOfLine)
    {
      hwy::Prefetch(&this->Entries[ray]);
    }
  }

  std::size_t NumberOfKnots() const
  {
    std::size_t knots = 0;
    for (std::size_t direction = 0; direction < NumberOfDirections; ++direction)
    {
      knots += this->Cells[direction].NumberOfRows() + this->Fitted[direction].NumberOfRows();
    }
    return knots;
  }

  std::size_t MemoryInBytes() const
  {
    std::size_t bytes = this->Entries.capacity() * sizeof(float);
    for (std::size_t direction = 0; direction < NumberOfDirections; ++direction)
    {
      bytes += this->Cells[direction].MemoryInBytes() + this->Fitted[direction].MemoryInBytes() +
        this->Normals[direction].MemoryInBytes();
    }
    return bytes;
  }
};

}

#endif
