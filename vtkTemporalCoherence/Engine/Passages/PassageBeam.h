// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PassageBeam_h
#define TemporalCoherence_PassageBeam_h

#include "Beams/TileBeam.h"
#include "Scene/GridCoordinates.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// A cell of a band, in single precision.
struct PassedCell
{
  /// Differences at the corners from the band's lowest isovalue. In their unit no difference from
  /// any isovalue of the band is above 1.
  CellValues Values;
  float KeysPerUnit = 0.0f; ///< at most 1e30
  bool IsAny = false;       ///< nothing is told of its values: it may pass any isovalue
};

/// By how much single precision may move what is given in units of keys, and more.
constexpr double KeySlack = 0.01;

/// Rays in a cell, by their numbers: the lowest and highest value there, in units of keys. Those
/// beyond the isovalues of the band are cut off somewhere behind these.
struct PassedKeys
{
  alignas(64) std::array<float, RayBatch::Capacity> Low, High;
};

/// The band that a beam finds passages of.
class PassageScene : public LeafSource
{
public:
  virtual void Read(const glm::ivec3& cell, PassedCell& values) = 0;

  /// Store passages of some rays, one bit each.
  /// \return one bit for each ray that needs no more
  virtual std::uint64_t Store(
    const glm::ivec3& cell, std::uint64_t which, const PassedKeys& keys) = 0;
};

/// What is searched.
struct PassageTask
{
  const ActiveCells& Active;   ///< of the band
  bool IsSolid;                ///< where a ray can only leave solids, nothing is passed
  bool HasCaps;                ///< solids are capped in any active cell
  const GridCoordinates* Grid; ///< of samples; null: they lie at integers
};

/// Take a beam through active cells, from front to back. Each ray meets cells in their order along
/// it. Where single precision cannot prove that a ray passes no isovalue of the band in a cell,
/// that is a passage. \pre beam.AreAlike
void FindPassages(const PassageTask& task, PassageScene& scene, TileBeam& beam);

}

#endif
