// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BandBeam_h
#define TemporalCoherence_BandBeam_h

#include "Isomap/BandCells.h"
#include "Lattice/CellRoot.h"
#include "Lattice/TileBeam.h"

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

/// The stay of a vector of rays in a cell, as arrays over rays.
template <typename Real>
struct alignas(64) CellStays
{
  template <typename Each>
  using Array = std::array<Each, WidestVector>;

  Array<double> Enter{}, Leave{};
  Array<Real> Lowest{}, Highest{}; ///< of the field from Enter to Leave
  std::array<Array<Real>, 4> Cubic{};

  std::size_t First = 0; ///< ray of the batch
  /// Rays whose progress the cell can raise, and rays whose walk surely passes the cell, one bit
  /// each.
  std::uint64_t Which = 0, IsOnWalk = 0;
};

/// The band that a beam goes through.
template <typename Real>
class BandBeamScene : public LeafSource
{
public:
  virtual void Read(const glm::ivec3* places, std::size_t count, BandCell<Real>* cells) = 0;

  /// Note a cell for its rays.
  /// \param beam gets the ends of rays that are done
  /// \return true if a ray is done
  virtual bool TakeNote(
    const BandCell<Real>& cell, const CellStays<Real>& rays, TileBeam& beam) = 0;

  /// The progress of rays, which the scene updates: BandProgress::ReachedIn.
  virtual const Real* ReachedIn(std::size_t direction) const = 0;
};

/// Take a beam through active cells, from front to back, until all its rays are done. Each ray
/// meets its cells in order along it. The scene gets every cell that a ray passes and that can
/// raise the ray's progress.
/// \pre beam.AreAlike
void SearchBand(
  const ActiveCells& active, const RayBatch& rays, BandBeamScene<float>& scene, TileBeam& beam);
void SearchBand(
  const ActiveCells& active, const RayBatch& rays, BandBeamScene<double>& scene, TileBeam& beam);

}

#endif
