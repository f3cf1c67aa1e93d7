// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_IsomapBuilder_h
#define TemporalCoherence_IsomapBuilder_h

#include "Isomap/FrameBands.h"
#include "Isomap/Isomap.h"
#include "Scene/FrameKey.h"
#include "Scene/Progress.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// Holds the isomap of one view: begins it, and builds the ranges that the user asks for.
class IsomapBuilder
{
public:
  /// The isomap of the view in which isovalues last changed.
  const Isomap& Built() const { return this->Map; }
  Isomap& ToBuild() { return this->Map; }

  /// The drag of isovalues in this view.
  DragState& Drag() { return this->State; }

  /// True if there are bands for all isovalues of a frame in the whole picture.
  bool Covers(const FrameKey& key, const Isomap::Options& options) const
  {
    return this->Map.IsOf(key, options) && this->Map.Covers(key.Isosurfaces().Isovalues);
  }

  /// True if building bands for a frame may succeed.
  bool CanBuild(const FrameKey& key, const Isomap::Options& options) const;

  /// Begin the isomap of a frame's view, if that has none, and build the range that the user asks
  /// for if it holds an isovalue of the frame.
  /// \return TooLarge if not even an empty isomap fits the memory limit. A range that is too large
  ///         does not prevent the use of the isomap
  /// \throws std::bad_alloc
  Isomap::Outcome Prepare(
    const BandSource& source, const Isomap::Options& options, const ReportProgress& report);

  /// Build the range that the user asks for, and narrow bands around the isovalues outside of it.
  /// \throws std::bad_alloc
  Isomap::Outcome BuildAhead(
    const BandSource& source, const Isomap::Options& options, const ReportProgress& report);

  /// Cells that the last call of Prepare or BuildAhead read.
  std::int64_t CellsRead() const { return this->Cells; }

  /// True if the memory limit was too low for the last request.
  bool IsTooLarge() const { return this->FailedLimit > 0 || this->IsRangeTooLarge; }

  /// True if bands were dropped because of the user's limit of memory.
  bool HasDropped() const { return this->State.HasDropped; }

  /// Build no more bands for this view: memory ran out.
  void GiveUp() { this->FailedLimit = std::numeric_limits<std::size_t>::max(); }

  /// Drop bands until they take at most this many bytes.
  void Trim(std::size_t limit);

  /// Reassign the isomap from the field `before` to `now`, whose samples are equal but lie
  /// elsewhere.
  void MoveTo(const Field& now, const Field& before) { this->Map.MoveTo(now, before); }

  /// The data has changed.
  void Release();

private:
  bool Begin(const BandSource& source, const Isomap::Options& options);
  void Ask(const ValueBand& range, const ValueRangePyramid& pyramid);
  void ForgetIfEmpty();
  Isomap::Outcome Build(const ValueBand& range, const BandSource& source,
    const Isomap::Options& options, const ReportProgress& report);

  /// A range that did not fit into a limit of memory.
  struct FailedRange
  {
    ValueBand Range;
    std::size_t Limit;
  };
  bool HasFailed(const ValueBand& range, std::size_t limit) const;
  void Note(const ValueBand& range, std::size_t limit, bool hasFailed);

  Isomap Map;
  DragState State;
  std::size_t FailedLimit = 0;           ///< memory limit that not even an empty isomap fitted
  std::vector<FailedRange> FailedRanges; ///< of this view, the latest ones
  bool IsRangeTooLarge = false;          ///< a range of the last frame to build did not fit
  ValueBand RangeAsked{ 1.0, 0.0 };      ///< by the last frame, or BuildAhead
  std::int64_t Cells = 0;
};

}

#endif
