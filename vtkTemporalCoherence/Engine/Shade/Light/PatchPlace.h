// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PatchPlace_h
#define TemporalCoherence_PatchPlace_h

#include "Scene/Frame.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace TemporalCoherence
{

/// The place of a surface point in a cache of light: one of the 64 *patches* of a block. A patch is
/// a cube in the space of the data, about as large as a pixel. Points of one surface share it if
/// they look to the same side.
struct PatchPlace
{
  glm::ivec3 Block;     ///< in units of four patches
  std::int16_t Level;   ///< edge of a patch: 2 to this power, in the world
  SurfaceIndex Surface; ///< position in the list of isovalues
  std::uint8_t Side;    ///< the axis that the normal is closest to, its sign, and the kind of hit
  std::uint8_t Patch;   ///< x + 4 y + 16 z
  std::uint16_t Source = 0; ///< 0: light from all sides; n: light number n - 1 of the appearance
};

/// True if two places lie in the same block.
inline bool AreTogether(const PatchPlace& a, const PatchPlace& b)
{
  return a.Block == b.Block && a.Level == b.Level && a.Surface == b.Surface && a.Side == b.Side &&
    a.Source == b.Source;
}

/// A number for the block of a place: equal for places in one block, else almost always different.
inline std::uint64_t HashOfBlock(const PatchPlace& place)
{
  const auto word = [](std::int64_t value) { return static_cast<std::uint64_t>(value); };
  const std::uint64_t rest = word(place.Level & 0xff) | word(place.Side) << 8 |
    word(place.Surface) << 16 | word(place.Source) << 48;
  // Multiples of odd constants, and the finaliser of MurmurHash3.
  std::uint64_t x = word(place.Block.x) * 0x9e3779b97f4a7c15ull +
    word(place.Block.y) * 0xc2b2ae3d27d4eb4full + word(place.Block.z) * 0x165667b19e3779f9ull +
    rest * 0xd6e8feb86659fd93ull;
  x ^= x >> 33;
  x *= 0xff51afd7ed558ccdull;
  return x ^ x >> 33;
}

/// Set the block and the patch of a place.
/// \param at in units of patches
inline void SetPatch(const glm::ivec3& at, PatchPlace& place)
{
  // Shifts round down, also below zero.
  place.Block = at >> 2;
  const glm::ivec3 in = at & 3;
  place.Patch = static_cast<std::uint8_t>(in.x + 4 * in.y + 16 * in.z);
}

/// The patch of the next larger size around a patch.
inline PatchPlace LargerThan(const PatchPlace& place)
{
  PatchPlace larger = place;
  const glm::ivec3 patch(place.Patch & 3, place.Patch >> 2 & 3, place.Patch >> 4);
  SetPatch((place.Block * 4 + patch) >> 1, larger);
  ++larger.Level;
  return larger;
}

/// The patch of a point on a surface.
/// \param point  in the space of the data: index space, with axes scaled to world lengths
/// \param normal there, of any length
/// \param width  of a pixel at the point, in the world
PatchPlace PlaceOfPatch(const glm::dvec3& point, const glm::vec3& normal, double width,
  SurfaceIndex surface, HitKind kind);

}

#endif
