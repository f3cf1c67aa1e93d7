// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A table gives each ray its rows in their order, however many rows there are: more than 65535 need
// wider offsets.
#include "Isomap/RayTable.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{

using namespace TemporalCoherence;

using Table = RayTable<std::uint32_t, std::uint16_t>;

/// Rows that go to rays 1, 3, 5, ... in turn.
std::vector<Table::Row> RowsOfOddRays(std::size_t count)
{
  std::vector<Table::Row> rows;
  for (std::size_t i = 0; i < count; ++i)
  {
    rows.push_back({ static_cast<std::uint8_t>((2 * i + 1) % RayBatch::Capacity),
      { static_cast<std::uint32_t>(i), static_cast<std::uint16_t>(i % 1000) } });
  }
  return rows;
}

/// True if each ray has its rows, in their order.
bool Holds(const Table& table, const std::vector<Table::Row>& rows)
{
  std::vector<std::size_t> next;
  for (std::size_t ray = 0; ray < RayBatch::Capacity; ++ray)
  {
    next.push_back(table.Begin(ray));
  }
  bool areSame = table.NumberOfRows() == rows.size() && table.Begin(0) == 0;
  for (const Table::Row& row : rows)
  {
    const std::size_t at = next[row.Ray]++;
    areSame = areSame && at < rows.size() && table.Get<0>()[at] == std::get<0>(row.Values) &&
      table.Get<1>()[at] == std::get<1>(row.Values);
  }
  for (std::size_t ray = 0; ray < RayBatch::Capacity; ++ray)
  {
    areSame = areSame && next[ray] == table.Begin(ray + 1);
  }
  return areSame;
}

TEST(RayTable, RaysHaveTheirRows)
{
  for (const std::size_t count : { 1u, 200u, 65535u, 65536u, 100000u })
  {
    const std::vector<Table::Row> rows = RowsOfOddRays(count);
    Table table;
    table.Assign(rows);
    EXPECT_TRUE(Holds(table, rows)) << count << " rows";
    EXPECT_LE(table.MemoryInBytes(), count * Table::BytesPerRow + 272);
  }
}

TEST(RayTable, FewRowsTakeNarrowOffsets)
{
  Table table;
  EXPECT_EQ(table.MemoryInBytes(), 0u);
  table.Assign(RowsOfOddRays(10));
  EXPECT_LE(table.MemoryInBytes(), 10 * Table::BytesPerRow + 140);
  table.Assign({});
  EXPECT_TRUE(table.IsEmpty());
  EXPECT_EQ(table.NumberOfRows(), 0u);
}

}
