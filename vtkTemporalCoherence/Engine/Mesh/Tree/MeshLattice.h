// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshLattice_h
#define TemporalCoherence_MeshLattice_h

#include <glm/glm.hpp>

#include <cstdint>

namespace TemporalCoherence
{

/// Lays an order of cells into a lattice, in which 64 consecutive cells are a block of 4^3 cells,
/// 64 consecutive blocks a block of 4^3 blocks, and so on.
///
/// Each six bits of a number are a place x + 4 y + 16 z within the next larger block. So a cell's
/// number divided by 64 is the number of its leaf, a leaf's number divided by 64 is the number of
/// its node, and the remainders are the bits of ActiveCells. The same functions serve cells, leaves
/// and nodes.
namespace MeshLattice
{

constexpr int BitsOfBlock = 6;
constexpr std::int64_t SizeOfBlock = 64;

/// The place of number n.
inline glm::ivec3 PlaceOf(std::int64_t n)
{
  glm::ivec3 place(0);
  for (int bits = 0; n != 0; bits += 2, n >>= BitsOfBlock)
  {
    place.x |= static_cast<int>(n & 3) << bits;
    place.y |= static_cast<int>(n >> 2 & 3) << bits;
    place.z |= static_cast<int>(n >> 4 & 3) << bits;
  }
  return place;
}

/// The number at a place.
inline std::int64_t NumberOf(glm::ivec3 place)
{
  std::int64_t n = 0;
  for (int bits = 0; (place.x | place.y | place.z) != 0; bits += BitsOfBlock)
  {
    const int block = (place.x & 3) | (place.y & 3) << 2 | (place.z & 3) << 4;
    n |= static_cast<std::int64_t>(block) << bits;
    place = glm::ivec3(place.x >> 2, place.y >> 2, place.z >> 2);
  }
  return n;
}

/// The smallest box that holds the places of the numbers 0 to count - 1.
inline glm::ivec3 SizeFor(std::int64_t count)
{
  if (count == 0)
  {
    return glm::ivec3(0);
  }
  const std::int64_t last = count - 1;
  glm::ivec3 farthest = PlaceOf(last);
  // The farthest smaller numbers clear one set bit of `last`, and set all bits below it.
  for (int bit = 0; last >> bit != 0; ++bit)
  {
    if ((last >> bit & 1) != 0)
    {
      const std::int64_t mask = (std::int64_t(1) << bit) - 1;
      farthest = glm::max(farthest, PlaceOf((last & ~(2 * mask + 1)) | mask));
    }
  }
  return farthest + 1;
}

}

}

#endif
