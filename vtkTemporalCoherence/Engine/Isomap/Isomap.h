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

/// For one view, where along each pixel's ray the field first passes each isovalue.
///
/// An isomap is made of bands of isovalues, each built when it is first needed.
class Isomap
{
public:
  struct Options
  {
    ValueBand Range{ 1.0, 0.0 };                      ///< isovalues of one band; none if Low > High
    std::size_t MemoryLimit = std::size_t(256) << 20; ///< bytes that all bands may take
    double Tolerance = 0.0;  ///< distance by which looked-up surfaces may be wrong, in voxels; one
                             ///< that is too small to be kept counts as 0
    bool HasNormals = false; ///< keep normals, to interpolate between them
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
    Stopped,   ///< by the report of its progress
    TooLarge,  ///< the band alone would exceed the limit of memory
    TooCostly, ///< it would read too many cells
    Impossible ///< there are no isovalues, no cells, too many cells, or no BandTracer
  };

  /// What a band may cost.
  struct Limits
  {
    std::size_t Memory;     ///< bytes that all bands may take
    double Cells;           ///< that may be read; an estimate after a part of them decides
    double Patience = 0.05; ///< seconds from one report to the next, but for the tiles in work then
  };

  /// Tolerances below this, in voxels, count as 0. Distances are kept in single precision, which
  /// may take a tenth of the tolerance: that is enough for rays as long as the longest diagonal of
  /// a cube of 960 voxels, and where they are longer, SmallestTolerance of a field is larger. Finer
  /// ones would gain nothing either: below some 2e-5 voxels not even the steepest surface could be
  /// told, as progress is kept to BandScale::StoredError, and every ray that hits would be traced.
  static constexpr double FinestTolerance = 1e-3;

  /// The same for the rays through a field.
  static double SmallestTolerance(const Field& field, const IndexTransform& transform);

  /// How the knots for a frame are kept.
  static KnotForm FormFor(const FrameKey& key, const Options& options);

  /// True if the kind of a field has isomaps, and its cells have numbers that fit the knots.
  static bool CanHold(const Field& field);

  /// True if this is the isomap of the view, data and mode of a frame, made as the options ask for.
  bool IsOf(const FrameKey& key, const Options& options) const;

  /// Begin an empty isomap for a frame's view, data and mode.
  void Begin(const FrameKey& key, const Options& options);

  /// Samples are equal to those of the field `before`, but lie elsewhere now.
  void MoveTo(const Field& now, const Field& before);

  /// Distance by which looked-up surfaces may be wrong; 0: they are exact.
  double Tolerance() const { return this->Form.Tolerance; }

  /// Where a band may begin: at what the picture of a lower isovalue shows.
  struct Start
  {
    const Frame* Picture = nullptr; ///< exact, of the same view; null: there is none
    double Isovalue = 0.0;
  };

  /// Trace a band and keep it. Bands that were not used for long are dropped where the limit of
  /// memory asks for it.
  /// \param pyramid of the frame's field
  /// \throws std::bad_alloc, the isomap then being as it was, but for dropped bands
  Outcome Build(const ValueBand& band, const ValueRangePyramid& pyramid, const Start& start,
    const Limits& limits, const ReportProgress& report);

  /// The isovalues around one without a band for which there is no band either; infinite where all
  /// are.
  ValueBand GapAround(double isovalue) const;

  /// Drop bands until they take no more than this.
  void Trim(std::size_t limit) { this->MakeRoom(0, limit); }

  /// The band that holds an isovalue, or null; marks it as used.
  const Band* Use(double isovalue);

  /// True if there is a band for each isovalue.
  bool Covers(const std::vector<double>& isovalues) const;

  const std::vector<std::shared_ptr<Band>>& Bands() const { return this->BuiltBands; }

  /// True if a band was dropped because of the limit of memory.
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
