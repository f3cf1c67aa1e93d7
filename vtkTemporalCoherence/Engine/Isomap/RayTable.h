// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RayTable_h
#define TemporalCoherence_RayTable_h

#include "Scene/RayBatch.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <tuple>
#include <vector>

namespace TemporalCoherence
{

/// Rows of values for each ray of a tile. They are stored column by column in one block of memory,
/// so that a search reads contiguous values. An empty table takes no memory.
/// \tparam Columns trivial types of at most 4 bytes, by descending alignment
template <typename... Columns>
class RayTable
{
public:
  template <std::size_t Column>
  using TypeOf = std::tuple_element_t<Column, std::tuple<Columns...>>;

  static constexpr std::size_t BytesPerRow = (sizeof(Columns) + ...);

  /// A row and the ray of the batch that it belongs to.
  struct Row
  {
    std::uint8_t Ray;
    std::tuple<Columns...> Values;
  };

  /// Set the rows. The order of the rows of a ray is preserved.
  /// \throws std::bad_alloc
  void Assign(const std::vector<Row>& rows)
  {
    this->Bytes.reset();
    if (rows.empty())
    {
      return;
    }
    Offsets begins{};
    for (const Row& row : rows)
    {
      ++begins[row.Ray + std::size_t(1)];
    }
    for (std::size_t ray = 0; ray < RayBatch::Capacity; ++ray)
    {
      begins[ray + 1] += begins[ray];
    }
    // Not filled with zeros first, as make_unique would.
    this->Bytes.reset(new std::byte[SizeFor(rows.size())]);
    this->Begins() = begins;
    for (const Row& row : rows)
    {
      this->Put(begins[row.Ray]++, row.Values, std::index_sequence_for<Columns...>());
    }
  }

  bool IsEmpty() const { return !this->Bytes; }

  /// Rows Begin(ray) .. Begin(ray + 1) - 1 belong to a ray. \pre the table is not empty
  std::size_t Begin(std::size_t ray) const
  {
    return (*reinterpret_cast<const Offsets*>(this->Bytes.get()))[ray];
  }

  std::size_t NumberOfRows() const { return this->Bytes ? this->Begin(RayBatch::Capacity) : 0; }

  std::size_t MemoryInBytes() const { return this->Bytes ? SizeFor(this->NumberOfRows()) : 0; }

  /// \pre the table is not empty
  template <std::size_t Column>
  const TypeOf<Column>* Get() const
  {
    return reinterpret_cast<const TypeOf<Column>*>(this->Bytes.get() + this->template At<Column>());
  }

private:
  using Offsets = std::array<std::uint32_t, RayBatch::Capacity + 1>;

  static std::size_t SizeFor(std::size_t rows) { return sizeof(Offsets) + rows * BytesPerRow; }

  Offsets& Begins() { return *reinterpret_cast<Offsets*>(this->Bytes.get()); }

  /// Where a column begins.
  template <std::size_t Column>
  std::size_t At() const
  {
    constexpr std::array<std::size_t, sizeof...(Columns)> sizes{ sizeof(Columns)... };
    std::size_t before = 0;
    for (std::size_t i = 0; i < Column; ++i)
    {
      before += sizes[i];
    }
    return sizeof(Offsets) + before * this->Begin(RayBatch::Capacity);
  }

  template <std::size_t... Column>
  void Put(std::size_t row, const std::tuple<Columns...>& values, std::index_sequence<Column...>)
  {
    ((const_cast<TypeOf<Column>*>(this->template Get<Column>())[row] = std::get<Column>(values)),
      ...);
  }

  std::unique_ptr<std::byte[]> Bytes;
};

}

#endif
