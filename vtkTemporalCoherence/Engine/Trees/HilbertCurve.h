// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HilbertCurve_h
#define TemporalCoherence_HilbertCurve_h

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// The curve through a cube of 2^bits places along each axis whose steps all have length 1. So a
/// piece of it is a compact body, which that of a Morton curve is not where the curve jumps.
///
/// Each octant is passed along the same curve, mirrored and turned: by one of 24 *states*, which
/// are the octant in which the curve begins and the axis along which it ends.
namespace HilbertCurve
{

constexpr unsigned int NumberOfStates = 24;

/// For each state and octant: 8 times the state within that octant, and the octant's turn.
using StateTable = std::array<std::uint8_t, 8 * NumberOfStates>;

/// The codes of octants whose neighbours differ in one bit.
constexpr unsigned int GrayCode(unsigned int turn)
{
  return turn ^ turn >> 1;
}

/// Rotate three bits.
constexpr unsigned int RotateUp(unsigned int bits, unsigned int count)
{
  return (bits << count % 3 | bits >> (3 - count % 3)) & 7u;
}

/// Where the curve begins in the octant of a turn, and the axis along which it goes there.
constexpr unsigned int BeginOf(unsigned int turn)
{
  return turn == 0 ? 0 : GrayCode((turn - 1) / 2 * 2);
}
constexpr unsigned int AxisOf(unsigned int turn)
{
  const unsigned int odd = turn == 0 ? 0 : turn - 1 + turn % 2;
  unsigned int ones = 0;
  for (; odd >> ones & 1u; ++ones)
  {
  }
  return ones % 3;
}

constexpr StateTable MakeStates()
{
  StateTable states{};
  for (unsigned int begin = 0; begin < 8; ++begin)
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      for (unsigned int turn = 0; turn < 8; ++turn)
      {
        const unsigned int octant = RotateUp(GrayCode(turn), axis + 1) ^ begin;
        const unsigned int nextBegin = begin ^ RotateUp(BeginOf(turn), axis + 1);
        const unsigned int nextAxis = (axis + AxisOf(turn) + 1) % 3;
        states[8 * (3 * begin + axis) + octant] =
          static_cast<std::uint8_t>(8 * (3 * nextBegin + nextAxis) + turn);
      }
    }
  }
  return states;
}

/// How many places the curve has passed before a place.
inline std::uint64_t NumberOf(std::uint32_t x, std::uint32_t y, std::uint32_t z, int bits)
{
  static constexpr StateTable States = MakeStates();
  std::uint64_t number = 0;
  std::size_t state = 0;
  for (int bit = bits - 1; bit >= 0; --bit)
  {
    const std::uint32_t octant = (x >> bit & 1u) | (y >> bit & 1u) << 1 | (z >> bit & 1u) << 2;
    const std::uint8_t next = States[state + octant];
    number = number << 3 | (next & 7u);
    state = next & 0xf8u;
  }
  return number;
}

}

}

#endif
