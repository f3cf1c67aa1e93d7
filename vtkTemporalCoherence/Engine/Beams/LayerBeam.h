// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LayerBeam_h
#define TemporalCoherence_LayerBeam_h

#include "Beams/TileBeam.h"
#include "Scene/GridCoordinates.h"
#include "Scene/LayerBatch.h"
#include "Trace/CellRoot.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// An isovalue that passes through a cell.
template <typename Real>
struct CellLevel
{
  std::int16_t Surface;        ///< position in the list of isovalues
  std::array<Real, 8> Corners; ///< differences from it
};

/// The isovalues that pass through a cell, in their order in the list.
template <typename Real>
struct CellLevels
{
  static constexpr std::size_t Most = 16;

  /// False if more pass through it. The others are not told then.
  bool AreAll() const { return this->Count <= Most; }

  std::size_t Count = 0;
  std::array<CellLevel<Real>, Most + 1> All;
};

/// What one ray meets in one cell behind what it is known to have met, from front to back. What
/// does not fit is left out from behind: it is as much as a pass may find.
struct CellSurfaces
{
  struct Met
  {
    double Distance;
    HitKind Kind;
    std::int16_t Surface;
  };

  std::size_t Count = 0;
  std::array<Met, LayerBatch::MostLayers> All;
};

/// The field that a beam finds layers in.
template <typename Real>
class LayerBeamScene : public LeafSource
{
public:
  /// Read a cell.
  virtual void Read(const glm::ivec3& cell, CellLevels<Real>& levels) = 0;

  /// Find all that one ray meets in a cell behind its last layer, as on a walk.
  virtual void SearchCell(
    const glm::ivec3& cell, std::size_t ray, const LayerBatch& layers, CellSurfaces& found) = 0;
};

/// What is searched.
struct LayerTask
{
  const ActiveCells& Active;
  const RayBatch& Rays;
  bool IsSolid; ///< only entries are surfaces
  bool HasCaps; ///< the scene tells where rays are in solids behind hidden cells
  /// Coordinates of samples; null: they lie at integers. On a grid the scene searches cells, too.
  const GridCoordinates* Grid;
};

/// Take a beam through active cells, from front to back, up to where all its rays are full or
/// opaque. Each ray meets cells in their order along it, and its surfaces are appended to its
/// layers. They are found as on a walk, with the same bits.
/// \return one bit for each ray whose surfaces lie too close together to be told in this way. It
///         must walk from its last layer on
/// \pre beam.AreAlike
std::uint64_t SearchLayers(
  const LayerTask& task, LayerBeamScene<float>& scene, TileBeam& beam, LayerBatch& layers);
std::uint64_t SearchLayers(
  const LayerTask& task, LayerBeamScene<double>& scene, TileBeam& beam, LayerBatch& layers);

}

#endif
