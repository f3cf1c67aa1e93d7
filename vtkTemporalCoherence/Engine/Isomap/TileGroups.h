// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileGroups_h
#define TemporalCoherence_TileGroups_h

#include "Scene/Tiles.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Isomaps are built by groups of TileGrain neighbouring tiles: few enough that a frame can build
/// a share of them, and many enough that their bookkeeping costs nothing.
struct TileRange
{
  std::int64_t First, End;
};

inline std::size_t NumberOfGroups(const glm::ivec2& pixels)
{
  return static_cast<std::size_t>((NumberOfTiles(pixels) + TileGrain - 1) / TileGrain);
}

inline TileRange TilesOfGroup(const glm::ivec2& pixels, std::size_t group)
{
  const std::int64_t first = static_cast<std::int64_t>(group) * TileGrain;
  return { first, std::min(first + TileGrain, NumberOfTiles(pixels)) };
}

/// A step from group to group that visits all of `groups`, spread over the picture.
std::size_t StrideOfGroups(std::size_t groups);

/// An order of all groups of a picture: squares of neighbours, one after the other, spread over the
/// picture. Active cells that the rays of a group compute serve its neighbours in the same frame.
/// \throws std::bad_alloc
std::vector<std::size_t> OrderOfGroups(const glm::ivec2& pixels);

}

#endif
