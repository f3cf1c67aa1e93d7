// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LayerBeam_h
#define TemporalCoherence_LayerBeam_h

#include "Lattice/CellRoot.h"
#include "Lattice/TileBeam.h"
#include "Scene/GridCoordinates.h"
#include "Scene/LayerBatch.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// An isovalue that passes through a cell.
template <typename Real>
struct CellLevel
{
  SurfaceIndex Surface;        ///< position in the list of isovalues
  std::array<Real, 8> Corners; ///< differences from it
};

/// The isovalues that pass through a cell, in their order in the list.
template <typename Real>
struct CellLevels
{
  static constexpr std::size_t Most = 16;

  /// False if more isovalues than Most pass through the cell; the list is then incomplete.
  bool AreAll() const { return this->Count <= Most; }

  std::size_t Count = 0;
  std::array<CellLevel<Real>, Most + 1> All;
};

/// The surfaces of one ray in one cell behind its last layer, from front to back. The list holds as
/// many as a pass may find, and drops farther surfaces.
struct CellSurfaces
{
  struct Met
  {
    double Distance;
    HitKind Kind;
    SurfaceIndex Surface;
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

  /// Find all surfaces of one ray in a cell behind its last layer, as a walk does.
  virtual void SearchCell(
    const glm::ivec3& cell, std::size_t ray, const LayerBatch& layers, CellSurfaces& found) = 0;
};

/// The input of SearchLayers.
struct LayerTask
{
  const ActiveCells& Active;
  const RayBatch& Rays;
  bool IsSolid; ///< only entries are surfaces
  bool HasCaps; ///< solids are capped behind hidden cells; the scene finds caps
  /// Coordinates of samples; null: they lie at integers. On a grid the scene searches cells, too.
  const GridCoordinates* Grid;
};

/// Take a beam through active cells, from front to back, until all its rays are full or opaque.
/// Each ray meets its cells in order along it, and its surfaces are appended to its layers. They
/// are bit-identical to the surfaces that a walk finds.
/// \return one bit for each ray whose surfaces lie too close together to sort. It must walk from
///         its last layer on
/// \pre beam.AreAlike
std::uint64_t SearchLayers(
  const LayerTask& task, LayerBeamScene<float>& scene, TileBeam& beam, LayerBatch& layers);
std::uint64_t SearchLayers(
  const LayerTask& task, LayerBeamScene<double>& scene, TileBeam& beam, LayerBatch& layers);

}

#endif
