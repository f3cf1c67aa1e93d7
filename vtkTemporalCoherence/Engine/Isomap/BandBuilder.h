// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BandBuilder_h
#define TemporalCoherence_BandBuilder_h

#include "Acceleration/ActiveCells.h"
#include "Acceleration/TileBounds.h"
#include "Acceleration/ValueRangePyramid.h"
#include "Isomap/BandTracer.h"
#include "Isomap/Isomap.h"
#include "Lattice/RaySource.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace TemporalCoherence
{

/// The frame that bands are built for. Its members must outlive the builders.
struct BandSource
{
  const FrameKey& Key;
  const ValueRangePyramid& Pyramid; ///< of the key's field
  BandTracerMaker MakeTracer;
};

/// Builds the knots of groups of tiles for one band of isovalues.
class BandBuilder
{
public:
  /// The arguments must outlive this.
  /// \param map     gives view, data and form of the knots
  /// \param bounds  of the band or of a wider band, or null; they only save time
  /// \param most    bytes of knots in one tile above which the whole band is too large
  /// \throws std::bad_alloc
  BandBuilder(const BandSource& source, const Isomap& map, const ValueBand& band,
    const TileBounds* bounds, std::size_t most);

  /// Find the bounds of a band, for builders.
  /// \throws std::bad_alloc; the bounds are then unusable
  static void FindBounds(const BandSource& source, const ValueBand& band, TileBounds& bounds);

  /// Build the band of a group. Thread-safe.
  /// \param cellsRead is increased
  /// \throws std::bad_alloc
  GroupBand Build(std::size_t group, std::int64_t& cellsRead) const;

private:
  bool CanSkip(std::int64_t tile) const;
  void Trace(std::int64_t tile, TileKnots* knots, std::int64_t& cellsRead) const;

  const FrameKey& Key;
  ValueBand Values;
  std::size_t Pieces;
  RaySource Rays;
  ActiveCells Active;
  const TileBounds* Bounds;
  std::shared_ptr<const BandTracer> Tracer;
};

}

#endif
