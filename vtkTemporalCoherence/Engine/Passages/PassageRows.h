// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PassageRows_h
#define TemporalCoherence_PassageRows_h

#include "Isomap/Knots.h"
#include "Scene/RayBatch.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// Keys that every isovalue of a band lies between.
constexpr BandScale::Key LowestKey = 0;
constexpr BandScale::Key HighestKey = std::numeric_limits<BandScale::Key>::max();

/// Collects the passages of the rays of a tile: those of each ray in their order along it, up to a
/// limit.
class PassageRows
{
public:
  /// More of a ray are not stored, so that memory is bounded: it is traced behind its last one. (At
  /// opacity 0.4 light passes 12 surfaces.)
  static constexpr std::size_t MostOfRay = 48;

  /// \param most bytes from which on nothing more is of use
  explicit PassageRows(std::size_t most)
    : MostBytes(most)
  {
    this->Count.fill(0);
  }

  /// Append a passage. \return true if none must follow on this ray: it is full, or all is
  bool Append(std::size_t ray, BandScale::Key low, BandScale::Key high, const glm::ivec3& cell)
  {
    if (this->Count[ray] == MostOfRay)
    {
      this->Truncated |= std::uint64_t(1) << ray;
      return true;
    }
    ++this->Count[ray];
    if (this->Rows.size() == this->Rows.capacity())
    {
      this->Rows.reserve(std::max(FirstRoom, 2 * this->Rows.size()));
    }
    this->Rows.push_back({ static_cast<std::uint8_t>(ray),
      { low, high,
        CellIndex{ static_cast<std::uint16_t>(cell.x), static_cast<std::uint16_t>(cell.y),
          static_cast<std::uint16_t>(cell.z) } } });
    return this->IsTooLarge();
  }

  bool IsTooLarge() const
  {
    return this->Rows.size() * PassageTable::BytesPerRow > this->MostBytes;
  }

  /// \throws std::bad_alloc
  void HandOver(TileKnots& knots) const
  {
    knots.Passages.Assign(this->Rows);
    knots.Unresolved = this->Truncated;
  }

private:
  static constexpr std::size_t FirstRoom = 8 * RayBatch::Capacity;

  std::size_t MostBytes;
  std::vector<PassageTable::Row> Rows;
  RayBatch::Array<std::uint8_t> Count;
  std::uint64_t Truncated = 0;
};

}

#endif
