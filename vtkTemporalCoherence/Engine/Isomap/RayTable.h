// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RayTable_h
#define TemporalCoherence_RayTable_h

#include "Scene/RayBatch.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <tuple>
#include <vector>

#include <hwy/cache_control.h>

namespace TemporalCoherence
{

/// Rows of values for each ray of a tile. They are stored column by column in one block of memory,
/// so that a search reads contiguous values. The begin of each ray's rows takes 16 bits, or 32 bits
/// in a table with more rows than 16 bits count. An empty table takes no memory.
/// \tparam Columns trivial types of at most 4 bytes, by descending alignment
template <typename... Columns>
class RayTable
{
public:
  template <std::size_t Column>
  using TypeOf = std::tuple_element_t<Column, std::tuple<Columns...>>;

  static constexpr std::size_t BytesPerRow = (sizeof(Columns) + ...);

  /// A row, with its ray's number in the batch.
  struct Row
  {
    std::uint8_t Ray;
    std::tuple<Columns...> Values;
  };

  /// Set the rows. Each ray's rows keep their order.
  /// \throws std::bad_alloc
  void Assign(const std::vector<Row>& rows)
  {
    this->Bytes.reset();
    if (rows.empty())
    {
      return;
    }
    Offsets<std::uint32_t> begins{};
    for (const Row& row : rows)
    {
      ++begins[row.Ray + std::size_t(1)];
    }
    for (std::size_t ray = 0; ray < RayBatch::Capacity; ++ray)
    {
      begins[ray + 1] += begins[ray];
    }
    // Avoids the zero fill of make_unique.
    this->Bytes.reset(new std::byte[SizeFor(rows.size())]);
    this->Head().Rows = static_cast<std::uint32_t>(rows.size());
    if (IsWide(rows.size()))
    {
      this->Begins<std::uint32_t>() = begins;
    }
    else
    {
      std::transform(begins.begin(), begins.end(), this->Begins<std::uint16_t>().begin(),
        [](std::uint32_t begin) { return static_cast<std::uint16_t>(begin); });
    }
    for (const Row& row : rows)
    {
      this->Put(begins[row.Ray]++, row.Values, std::index_sequence_for<Columns...>());
    }
  }

  bool IsEmpty() const { return !this->Bytes; }

  /// Prefetch the table; only the first part of a long one.
  void Prefetch() const
  {
    constexpr std::size_t line = 64, most = 64 * line;
    const std::size_t size = std::min(this->MemoryInBytes(), most);
    for (std::size_t at = 0; at < size; at += line)
    {
      hwy::Prefetch(this->Bytes.get() + at);
    }
  }

  /// Rows Begin(ray) .. Begin(ray + 1) - 1 belong to a ray.
  /// \pre the table is not empty
  std::size_t Begin(std::size_t ray) const
  {
    return IsWide(this->Head().Rows) ? this->template Begins<std::uint32_t>()[ray]
                                     : this->template Begins<std::uint16_t>()[ray];
  }

  /// The begins of all rays' rows in 16 bits; null if the table uses 32 bits.
  /// \pre the table is not empty
  const std::uint16_t* NarrowBegins() const
  {
    return IsWide(this->Head().Rows) ? nullptr : this->template Begins<std::uint16_t>().data();
  }

  std::size_t NumberOfRows() const { return this->Bytes ? this->Head().Rows : 0; }

  std::size_t MemoryInBytes() const { return this->Bytes ? SizeFor(this->NumberOfRows()) : 0; }

  /// \pre the table is not empty
  template <std::size_t Column>
  const TypeOf<Column>* Get() const
  {
    return reinterpret_cast<const TypeOf<Column>*>(this->Bytes.get() + this->template At<Column>());
  }

private:
  template <typename Offset>
  using Offsets = std::array<Offset, RayBatch::Capacity + 1>;

  /// The head of a table; the begins of rows follow.
  struct Header
  {
    std::uint32_t Rows;
  };

  static bool IsWide(std::size_t rows) { return rows > std::numeric_limits<std::uint16_t>::max(); }

  /// Bytes before the first column, which is aligned.
  static std::size_t BeginOfColumns(std::size_t rows)
  {
    const std::size_t bytes = sizeof(Header) +
      (IsWide(rows) ? sizeof(Offsets<std::uint32_t>) : sizeof(Offsets<std::uint16_t>));
    constexpr std::size_t alignment = 4;
    return (bytes + alignment - 1) / alignment * alignment;
  }

  static std::size_t SizeFor(std::size_t rows) { return BeginOfColumns(rows) + rows * BytesPerRow; }

  Header& Head() { return *reinterpret_cast<Header*>(this->Bytes.get()); }
  const Header& Head() const { return *reinterpret_cast<const Header*>(this->Bytes.get()); }

  template <typename Offset>
  Offsets<Offset>& Begins()
  {
    return *reinterpret_cast<Offsets<Offset>*>(this->Bytes.get() + sizeof(Header));
  }
  template <typename Offset>
  const Offsets<Offset>& Begins() const
  {
    return *reinterpret_cast<const Offsets<Offset>*>(this->Bytes.get() + sizeof(Header));
  }

  /// Byte offset of a column.
  template <std::size_t Column>
  std::size_t At() const
  {
    constexpr std::array<std::size_t, sizeof...(Columns)> sizes{ sizeof(Columns)... };
    std::size_t before = 0;
    for (std::size_t i = 0; i < Column; ++i)
    {
      before += sizes[i];
    }
    return BeginOfColumns(this->Head().Rows) + before * this->Head().Rows;
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
