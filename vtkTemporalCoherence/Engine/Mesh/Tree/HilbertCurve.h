// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HilbertCurve_h
#define TemporalCoherence_HilbertCurve_h

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// The Hilbert curve through a cube of 2^bits places along each axis. All of its steps have length
/// 1, so its pieces are compact; pieces of a Morton curve are not where the curve jumps.
///
/// The curve in each octant is a mirrored and rotated copy of the curve, with one of 24 *states*:
/// the octant where it begins, and the axis from its beginning to its end.
namespace HilbertCurve
{

constexpr unsigned int NumberOfStates = 24;

/// For each state and octant: 8 times the state within that octant, and the octant's turn.
using StateTable = std::array<std::uint8_t, 8 * NumberOfStates>;

/// Codes of octants: successive codes differ in one bit.
constexpr unsigned int GrayCode(unsigned int turn)
{
  return turn ^ turn >> 1;
}

/// Rotate three bits.
constexpr unsigned int RotateUp(unsigned int bits, unsigned int count)
{
  return (bits << count % 3 | bits >> (3 - count % 3)) & 7u;
}

/// The corner where the curve enters octant number `turn`, and the axis from its entry to its exit.
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

/// The number of places on the curve before a place.
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
