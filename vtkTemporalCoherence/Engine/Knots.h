// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Knots_h
#define TemporalCoherence_Knots_h

#include "RayTable.h"
#include "Surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Which way the field passes isovalues along a ray.
enum class Course : std::uint8_t
{
  Rising, ///< from below to above; isovalues in ascending order, from the band's lowest
  Falling ///< from above to below; isovalues in descending order, from the band's highest
};
constexpr std::size_t NumberOfCourses = 2;

/// Progress through a band on a course: 0 at the first isovalue of the band, `Span` at the last. A
/// ray that has come to progress p has passed all isovalues up to p.
struct BandScale
{
  explicit BandScale(const ValueBand& band)
    : Low(band.Low)
    , Span(band.High - band.Low)
    , KeysPerUnit(this->Span > 0.0 ? (LargestKey - 2) / this->Span : 0.0)
  {
  }

  /// Progress at a difference from the band's lowest isovalue.
  double Progress(Course course, double difference) const
  {
    return course == Course::Rising ? difference : this->Span - difference;
  }

  using Key = std::uint16_t;
  static constexpr double LargestKey = 65535.0;

  /// Progress as an integer, rounded up: 0 before the band, LargestKey behind it. Keys keep the
  /// order of what they stand for, so that a search for an isovalue's key never goes too far.
  Key KeyOf(double progress) const
  {
    if (!(progress >= 0.0))
    {
      return 0;
    }
    return static_cast<Key>(std::min(1.0 + std::ceil(progress * this->KeysPerUnit), LargestKey));
  }

  double Low, Span, KeysPerUnit;
};

/// The cells in which a ray comes farther through the band than before, in order along the ray: the
/// first whose path key is that of an isovalue or more holds the ray's crossing of it, and the
/// first whose corner key is, is the first that the isovalue passes through at all.
///
/// Columns: path key (of the field along the ray), corner key (of the samples at its corners),
/// first corner of the cell.
using CellIndex = std::array<std::uint16_t, 3>;
using CellKnots = RayTable<BandScale::Key, BandScale::Key, CellIndex>;

/// Distance at which a ray enters a cell, as kernels compute it.
inline double EntryInto(const CellIndex& cell, const RayBatch& rays, std::size_t ray)
{
  double enter = rays.Begin[ray];
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double behind = cell[a] + (rays.Direction[a][ray] > 0.0 ? 0.0 : 1.0);
    enter = std::max(enter, (behind - rays.Origin[a][ray]) * rays.Inverse[a][ray]);
  }
  return enter;
}

/// The first of the ascending keys begin .. end - 1 that is not below a key.
inline std::size_t FirstOf(
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

/// What the rays of a tile know about the isovalues of a band.
struct TileKnots
{
  std::array<CellKnots, NumberOfCourses> Cells;

  /// The field's difference from the band's lowest isovalue where the rays begin; -infinity where
  /// it is below the band. Empty: it is for all rays.
  std::vector<float> Entries;

  bool IsEmpty() const
  {
    return this->Cells[0].IsEmpty() && this->Cells[1].IsEmpty() && this->Entries.empty();
  }

  std::size_t NumberOfKnots() const
  {
    return this->Cells[0].NumberOfRows() + this->Cells[1].NumberOfRows();
  }

  std::size_t MemoryInBytes() const
  {
    return this->Cells[0].MemoryInBytes() + this->Cells[1].MemoryInBytes() +
      this->Entries.capacity() * sizeof(float);
  }
};

}

#endif
