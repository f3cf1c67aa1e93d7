// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/TileGroups.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace TemporalCoherence
{

namespace
{

/// Rows of tiles in a square of groups. Its groups share the active cells computed in leaves.
constexpr std::int64_t RowsOfSquare = 8;

}

std::size_t StrideOfGroups(std::size_t groups)
{
  std::size_t stride = static_cast<std::size_t>(0.618 * static_cast<double>(groups)) | 1u;
  while (std::gcd(stride, groups) != 1)
  {
    ++stride;
  }
  return stride;
}

std::vector<std::size_t> OrderOfGroups(const glm::ivec2& pixels)
{
  // Sort by squares, which need not be whole at the borders of the picture.
  using Place = std::array<std::int64_t, 4>;
  const std::int64_t columns = TilesOf(pixels).x;
  std::vector<Place> places(NumberOfGroups(pixels));
  for (std::size_t group = 0; group < places.size(); ++group)
  {
    const std::int64_t tile = TilesOfGroup(pixels, group).First;
    const std::int64_t row = tile / columns, column = tile % columns;
    places[group] = { row / RowsOfSquare, column / TileGrain, row,
      static_cast<std::int64_t>(group) };
  }
  std::sort(places.begin(), places.end());
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (i == 0 || places[i][0] != places[i - 1][0] || places[i][1] != places[i - 1][1])
    {
      first.push_back(i);
    }
  }

  std::vector<std::size_t> order;
  order.reserve(places.size());
  const std::size_t squares = first.size(), stride = StrideOfGroups(squares);
  first.push_back(places.size());
  for (std::size_t i = 0; i < squares; ++i)
  {
    const std::size_t square = i * stride % squares;
    for (std::size_t at = first[square]; at < first[square + 1]; ++at)
    {
      order.push_back(static_cast<std::size_t>(places[at][3]));
    }
  }
  return order;
}

}
