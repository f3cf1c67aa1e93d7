// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BandBeam_h
#define TemporalCoherence_BandBeam_h

#include "Fields/TileBeam.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// What the rays of a beam have reached in a band for sure. Progress is that of BandScale, in
/// single precision and a unit of its own.
struct alignas(64) BandReach
{
  RayBatch::Array<float> Rising, Falling; ///< Done: nothing ahead matters in this direction
  /// One bit for each ray that may have passed an active cell: later ones do not tell where it
  /// begins.
  std::uint64_t Entered = 0;
  float Span; ///< progress at the end of the band

  static constexpr float Done = 1e37f;
  static constexpr float NotBegun = -1e37f;
};

/// A cell of a band, in single precision.
struct BandCell
{
  std::array<float, 8> Corners; ///< differences from the lowest isovalue
  float ToRise, ToFall;         ///< progress that rays can make here at most
  bool IsFinite;                ///< all samples are
};

/// Cells that may bring rays on; those of each ray in their order along it.
struct NotedCells
{
  /// One cell adds a tile's rays at most.
  static constexpr std::size_t Capacity = 2 * RayBatch::Capacity;

  std::size_t Count = 0;
  std::array<std::uint8_t, Capacity> Ray, Cell;
};

/// The band that a beam goes through.
class BandBeamScene : public LeafSource
{
public:
  /// Read cells, and remember them by the numbers first, first + 1 and so on below MostCells.
  virtual void Read(
    const glm::ivec3* places, std::size_t count, std::size_t first, BandCell* cells) = 0;
  static constexpr std::size_t MostCells = 256;

  /// Find out, in full precision, what the first `count` of the noted cells bring.
  /// \param reach, beam are brought up to date
  virtual void Measure(
    const NotedCells& noted, std::size_t count, BandReach& reach, TileBeam& beam) = 0;
};

/// True if all rays of a beam meet cells in the order of SearchBand.
bool AreRaysAlike(const TileBeam& beam);

/// Take a beam through active cells, from front to back, up to where all its rays are done. A cell
/// that is not noted for a ray does not bring it on.
/// \pre AreRaysAlike(beam)
void SearchBand(const ActiveCells& active, BandBeamScene& scene, BandReach& reach, TileBeam& beam);

}

#endif
