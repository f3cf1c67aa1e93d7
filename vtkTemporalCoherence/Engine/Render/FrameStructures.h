// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FrameStructures_h
#define TemporalCoherence_FrameStructures_h

#include "Acceleration/FieldStructures.h"
#include "Acceleration/TileBounds.h"
#include "Scene/FrameKey.h"
#include "Shade/TileCompositor.h"

#include <memory>
#include <utility>

namespace TemporalCoherence
{

/// What tells a frame where surfaces can be. Each structure stays for as long as it fits: value
/// ranges belong to the data, active cells to data and isovalues, bounds of tiles to a frame.
class FrameStructures
{
public:
  /// \param shared where to get structures that others who look at the same data may have
  explicit FrameStructures(std::shared_ptr<FieldStructures> shared)
    : Shared(std::move(shared))
  {
  }

  /// True if value ranges are needed for a key, and those that are here are others. Where there are
  /// no cells or no isovalues, they are not needed.
  bool NeedsRanges(const FrameKey& key) const;

  /// Make the value ranges those of a key's samples, if they are needed.
  /// \throws std::bad_alloc, the ranges then being empty
  void PrepareRanges(const FrameKey& key);

  /// Make active cells and bounds of tiles those of a key, likewise.
  /// \pre PrepareRanges was called
  /// \throws std::bad_alloc
  void PrepareActiveCells(const FrameKey& key);

  const FieldRanges& Ranges() const { return *this->OfData; }
  const ValueRangePyramid& Pyramid() const { return *this->OfData->Pyramid; }

  /// What rays leap over by active cells and bounds, which are prepared; nothing if they are not to
  /// leap.
  LeapedSpace SpaceToLeap(bool leaps) const
  {
    return { leaps ? this->OfSurfaces->Active.get() : nullptr, &this->Bounds };
  }

  /// The value ranges of a key's samples, which need not be the ones that are kept here.
  /// \throws std::bad_alloc
  std::shared_ptr<const FieldRanges> RangesOf(const FrameKey& key) const;

  /// Samples are equal to those of the field `before`, but lie elsewhere now.
  void MoveTo(const Field& now, const Field& before);

  FieldStructures& SharedByAll() { return *this->Shared; }
  const std::shared_ptr<FieldStructures>& Sharing() const { return this->Shared; }

private:
  std::shared_ptr<FieldStructures> Shared;
  std::shared_ptr<const FieldRanges> OfData = std::make_shared<const FieldRanges>();
  std::shared_ptr<const SurfaceCells> OfSurfaces = std::make_shared<const SurfaceCells>();
  TileBounds Bounds;
};

}

#endif
