// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Isomap_h
#define TemporalCoherence_Isomap_h

#include "Acceleration/ValueRangePyramid.h"
#include "Isomap/KnotCollector.h"
#include "Isomap/Knots.h"
#include "Scene/FrameKey.h"
#include "Scene/Progress.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// For one view: where the ray of each pixel first passes each isovalue.
///
/// An isomap is made of bands of isovalues, each built when it is first needed.
class Isomap
{
public:
  struct Options
  {
    ValueBand Range{ 1.0, 0.0 }; ///< asks for one band of these isovalues; none if Low > High
    std::size_t MemoryLimit = std::size_t(256) << 20; ///< limit of all bands together, in bytes
    double Tolerance = 0.0; ///< largest error in the distance of looked-up surfaces, in voxels; too
                            ///< small a tolerance counts as 0
    bool HasNormals = false; ///< store normals, to interpolate between them
  };

  /// A band of isovalues of the view.
  struct Band
  {
    ValueBand Values;
    bool HasNormals = false;
    std::vector<TileKnots> Tiles; ///< by number of the tile, and of the piece of its rays
    std::size_t Pieces = 1;       ///< that a ray may have in the region
    std::size_t Memory = 0;       ///< bytes
    std::size_t NumberOfKnots = 0;
    std::int64_t CellsRead = 0; ///< to build it
    std::uint64_t LastUse = 0;

    /// What the rays of a tile know, for each of their pieces.
    TileKnots* At(std::int64_t tile)
    {
      return this->Tiles.data() + static_cast<std::size_t>(tile) * this->Pieces;
    }
    const TileKnots* At(std::int64_t tile) const
    {
      return this->Tiles.data() + static_cast<std::size_t>(tile) * this->Pieces;
    }
    bool IsEmpty(std::int64_t tile) const;
  };

  enum class Outcome : std::uint8_t
  {
    Built,
    Stopped,   ///< by the progress report
    TooLarge,  ///< the band alone would exceed the limit of memory
    TooCostly, ///< it would read too many cells
    Impossible ///< there are no isovalues, no cells, too many cells, or no BandTracer
  };

  /// Limits for building a band.
  struct Limits
  {
    std::size_t Memory;     ///< limit of all bands together, in bytes
    double Cells;           ///< limit of cells to read; decided by an estimate after a part of them
    double Patience = 0.05; ///< seconds between reports, plus the time to finish the tiles in work
  };

  /// Tolerances below this, in voxels, count as 0. Distances are stored in single precision, which
  /// may take a tenth of the tolerance. This suffices for the diagonal of a cube of 960 voxels; for
  /// larger fields, SmallestTolerance is larger. Finer tolerances would gain nothing: progress is
  /// stored to BandScale::StoredError, so below some 2e-5 voxels not even the steepest surface
  /// could be located, and every ray would be traced.
  static constexpr double FinestTolerance = 1e-3;

  /// The same for a field of any size.
  static double SmallestTolerance(const Field& field, const IndexTransform& transform);

  /// The form of the knots for a frame.
  static KnotForm FormFor(const FrameKey& key, const Options& options);

  /// True if the kind of a field has isomaps, and its cell indices fit into knots.
  static bool CanHold(const Field& field);

  /// True if this isomap belongs to the view, data and mode of a frame, and has the form that the
  /// options ask for.
  bool IsOf(const FrameKey& key, const Options& options) const;

  /// Begin an empty isomap for a frame's view, data and mode.
  void Begin(const FrameKey& key, const Options& options);

  /// Reassign the isomap from the field `before` to `now`, whose samples are equal but lie
  /// elsewhere.
  void MoveTo(const Field& now, const Field& before);

  /// Largest error in the distance of looked-up surfaces; 0: they are exact.
  double Tolerance() const { return this->Form.Tolerance; }

  /// Trace a band and add it. Least recently used bands are dropped if the memory limit requires
  /// it.
  /// \param pyramid of the frame's field
  /// \throws std::bad_alloc; the isomap is then unchanged, except for dropped bands
  Outcome Build(const ValueBand& band, const ValueRangePyramid& pyramid, const Limits& limits,
    const ReportProgress& report);

  /// The gap between bands around an isovalue without a band; infinite on a side without bands.
  ValueBand GapAround(double isovalue) const;

  /// Drop bands until they take at most this many bytes.
  void Trim(std::size_t limit)
  {
    this->MakeRoom(0, limit);
    this->Dropped &= limit > 0; // without a limit nobody wants an isomap
  }

  /// The band that holds an isovalue, or null. Marks the band as used.
  const Band* Use(double isovalue);

  /// True if there is a band for each isovalue.
  bool Covers(const std::vector<double>& isovalues) const;

  const std::vector<std::shared_ptr<Band>>& Bands() const { return this->BuiltBands; }

  /// True if a band was dropped because of the memory limit.
  bool HasDropped() const { return this->Dropped; }

  std::size_t MemoryInBytes() const;
  std::size_t NumberOfKnots() const;

  void Release();

private:
  struct BandSource;

  bool MakeRoom(std::size_t bytes, std::size_t limit);

  FrameKey Key;
  KnotForm Form;
  bool IsBegun = false;
  bool Dropped = false;
  std::uint64_t Uses = 0;
  std::vector<std::shared_ptr<Band>> BuiltBands;
};

}

#endif
