// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PassageRows_h
#define TemporalCoherence_PassageRows_h

#include "Isomap/Knots.h"
#include "Passages/PassageBeam.h"
#include "Scene/RayBatch.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// Keys of the values from `low` to `high`, which are given in units of keys.
struct KeyRange
{
  static KeyRange Of(double low, double high)
  {
    constexpr double highest = std::numeric_limits<PassageKey>::max();
    return { static_cast<PassageKey>(std::clamp(low - KeySlack, 0.0, highest)),
      static_cast<PassageKey>(std::clamp(high + KeySlack, 0.0, highest)) };
  }
  static KeyRange OfAll() { return { 0, std::numeric_limits<PassageKey>::max() }; }

  PassageKey Low, High;
};

/// Collects the passages of the rays of a tile: those of each ray in their order along it, up to a
/// limit.
class PassageRows
{
public:
  /// More of a ray are not stored, so that memory is bounded: it is traced behind its last one. (At
  /// opacity 0.4 light passes 12 surfaces.)
  static constexpr std::size_t MostOfRay = 96;

  /// \param most bytes from which on nothing more is of use
  explicit PassageRows(std::size_t most)
    : MostBytes(most)
  {
    this->Count.fill(0);
  }

  /// Add a cell for passages. \return its number
  std::uint16_t AddCell(const glm::ivec3& cell)
  {
    this->Cells.push_back({ static_cast<std::uint16_t>(cell.x), static_cast<std::uint16_t>(cell.y),
      static_cast<std::uint16_t>(cell.z) });
    return static_cast<std::uint16_t>(this->Cells.size() - 1);
  }

  /// Append a passage through a cell.
  /// \return true if none must follow on this ray: it is full, or all is
  bool Append(std::size_t ray, const KeyRange& keys, std::uint16_t cell)
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
    this->Rows.push_back({ static_cast<std::uint8_t>(ray), { cell, keys.Low, keys.High } });
    return this->IsTooLarge();
  }

  bool IsTooLarge() const
  {
    return this->Rows.size() * PassageTable::RowsOfRays::BytesPerRow +
      this->Cells.size() * sizeof(CellIndex) >
      this->MostBytes;
  }

  /// \throws std::bad_alloc
  void HandOver(TileKnots& knots) const
  {
    knots.Passages.Rows.Assign(this->Rows);
    if (!this->Cells.empty())
    {
      knots.Passages.Cells.reset(new CellIndex[this->Cells.size()]);
      std::copy(this->Cells.begin(), this->Cells.end(), knots.Passages.Cells.get());
      knots.Passages.NumberOfCells = static_cast<std::uint16_t>(this->Cells.size());
    }
    knots.Unresolved = this->Truncated;
  }

private:
  static constexpr std::size_t FirstRoom = 16 * RayBatch::Capacity;

  std::size_t MostBytes;
  std::vector<PassageTable::RowsOfRays::Row> Rows;
  std::vector<CellIndex> Cells;
  RayBatch::Array<std::uint8_t> Count;
  std::uint64_t Truncated = 0;
};

}

#endif
