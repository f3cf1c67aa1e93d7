// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FrameStructures_h
#define TemporalCoherence_FrameStructures_h

#include "Acceleration/FieldStructures.h"
#include "Acceleration/TileBounds.h"
#include "Scene/FrameKey.h"
#include "Volumes/Beams/CompositeTables.h"
#include "Volumes/Samples/VisibleComponents.h"

#include <memory>
#include <utility>
#include <vector>

namespace TemporalCoherence
{

/// True if a key may show anything of its field. Of others nothing is prepared.
bool MayShowAnything(const FrameKey& key);

/// The structures that bound where surfaces can be. Each is rebuilt only when its input changes:
/// value ranges with the data, active cells with data and isovalues, tile bounds with cells and
/// view.
class FrameStructures
{
public:
  /// \param shared structures, also used by other viewers of the same data
  explicit FrameStructures(std::shared_ptr<FieldStructures> shared)
    : Shared(std::move(shared))
  {
  }

  /// True if a key needs value ranges that are not prepared. Without cells or isovalues it needs
  /// none.
  bool NeedsRanges(const FrameKey& key) const;

  /// Prepare the value ranges of a key's samples, if they are needed.
  /// \throws std::bad_alloc; the ranges are then empty
  void PrepareRanges(const FrameKey& key);

  /// Prepare the active cells and tile bounds of a key, if they are needed.
  /// \pre PrepareRanges was called
  /// \throws std::bad_alloc
  void PrepareActiveCells(const FrameKey& key);

  /// Prepare the cells in which the volume of a key can be seen, and their tile bounds.
  /// \return false if every cell may be visible; nothing is prepared then
  bool PrepareVisibleCells(const FrameKey& key);

  const FieldRanges& Ranges() const { return *this->OfData; }
  const ValueRangePyramid& Pyramid() const { return *this->OfData->Pyramid; }

  /// The prepared active cells and bounds for space leaping; empty if leaping is off.
  LeapedSpace SpaceToLeap(bool leaps) const
  {
    return { leaps ? this->OfSurfaces->Active.get() : nullptr, &this->Bounds };
  }

  /// The prepared visible cells and bounds for space leaping; empty if leaping is off.
  LeapedSpace VisibleSpace(bool leaps) const
  {
    return { leaps ? this->OfVolume->Active.get() : nullptr, &this->Bounds };
  }

  /// The value ranges of a key's samples: the prepared ranges or, for other samples, new ones.
  /// \throws std::bad_alloc
  std::shared_ptr<const FieldRanges> RangesOf(const FrameKey& key) const;

  /// The key with the hidden cells of its samples.
  /// \param ranges of its samples, if it needs any
  static FrameKey WithHidden(const FrameKey& key, const FieldRanges& ranges);

  /// Reassign structures of the field `before` to `now`, whose samples are equal but lie elsewhere.
  void MoveTo(const Field& now, const Field& before);

  /// The tables of the last composite volume.
  KeptTables& TablesOfVolume() { return this->Tables; }

  FieldStructures& SharedByAll() { return *this->Shared; }
  const std::shared_ptr<FieldStructures>& Sharing() const { return this->Shared; }

private:
  void PrepareBounds(const FrameKey& key, const ActiveCells& cells);
  std::vector<VisibleValues> VisibleValuesOf(
    const FrameKey& key, const std::vector<SeenBands>& bands);

  std::shared_ptr<FieldStructures> Shared;
  std::shared_ptr<const FieldRanges> OfData = std::make_shared<const FieldRanges>();
  std::shared_ptr<const SurfaceCells> OfSurfaces = std::make_shared<const SurfaceCells>();
  std::vector<std::shared_ptr<const FieldRanges>> OfOthers; ///< Blending::Others
  std::shared_ptr<const VisibleCells> OfVolume = std::make_shared<const VisibleCells>();
  KeptTables Tables;
  TileBounds Bounds;
  // The input of Bounds:
  const ActiveCells* BoundCells = nullptr; ///< of OfSurfaces or OfVolume; null: Bounds are invalid
  View BoundView;
  IndexTransform BoundTransform;
};

}

#endif
