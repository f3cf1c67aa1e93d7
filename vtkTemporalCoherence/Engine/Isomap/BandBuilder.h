// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BandBuilder_h
#define TemporalCoherence_BandBuilder_h

#include "Acceleration/ActiveCells.h"
#include "Acceleration/TileBounds.h"
#include "Acceleration/ValueRangePyramid.h"
#include "Isomap/BandTracer.h"
#include "Isomap/Isomap.h"
#include "Trace/RaySource.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace TemporalCoherence
{

/// Builds the knots of groups of tiles for one band of isovalues.
class BandBuilder
{
public:
  /// The arguments must outlive this.
  /// \param map     gives view, data and form of the knots
  /// \param pyramid of the field of `key`
  /// \param bounds  of the band or of a wider one; null for none. The knots are the same
  /// \param most    bytes of knots in a tile from which the band is too large anyway
  /// \throws std::bad_alloc
  BandBuilder(const FrameKey& key, const Isomap& map, const ValueRangePyramid& pyramid,
    const ValueBand& band, const TileBounds* bounds, std::size_t most);

  /// Find the bounds of a band, for builders.
  /// \throws std::bad_alloc; the bounds are then unusable
  static void FindBounds(const FrameKey& key, const ValueRangePyramid& pyramid,
    const ValueBand& band, TileBounds& bounds);

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
