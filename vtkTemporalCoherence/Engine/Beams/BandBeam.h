// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BandBeam_h
#define TemporalCoherence_BandBeam_h

#include "Beams/TileBeam.h"
#include "Isomap/BandCells.h"
#include "Trace/CellRoot.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// A cell of a band.
template <typename Real>
struct BandCell
{
  glm::ivec3 Place;
  std::array<Real, 8> Samples; ///< differences from the lowest isovalue
  CellReach<Real> Reach;
};

/// A vector of rays in a cell, as arrays over them.
template <typename Real>
struct alignas(64) CellStays
{
  template <typename Each>
  using Array = std::array<Each, WidestVector>;

  Array<double> Enter{}, Leave{};
  Array<Real> Lowest{}, Highest{}; ///< of the field between
  std::array<Array<Real>, 4> Cubic{};

  std::size_t First = 0; ///< ray of the batch
  /// One bit for each ray that the cell can bring on, and for each whose walk goes through it for
  /// sure.
  std::uint64_t Which = 0, IsOnWalk = 0;
};

/// The band that a beam goes through.
template <typename Real>
class BandBeamScene : public LeafSource
{
public:
  virtual void Read(const glm::ivec3* places, std::size_t count, BandCell<Real>* cells) = 0;

  /// Take note of a cell.
  /// \param beam rays end where they are done
  /// \return true if some ray is
  virtual bool TakeNote(
    const BandCell<Real>& cell, const CellStays<Real>& rays, TileBeam& beam) = 0;

  /// What rays have reached, of which a scene keeps account: BandProgress::ReachedIn.
  virtual const Real* ReachedIn(std::size_t direction) const = 0;
};

/// Take a beam through active cells, from front to back, up to where all its rays are done. Each
/// ray meets cells in their order along it. The scene is told of all that it passes and that can
/// bring it on.
/// \pre beam.AreAlike
void SearchBand(
  const ActiveCells& active, const RayBatch& rays, BandBeamScene<float>& scene, TileBeam& beam);
void SearchBand(
  const ActiveCells& active, const RayBatch& rays, BandBeamScene<double>& scene, TileBeam& beam);

}

#endif
