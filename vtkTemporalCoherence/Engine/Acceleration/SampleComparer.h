// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SampleComparer_h
#define TemporalCoherence_SampleComparer_h

#include "Acceleration/FieldFingerprint.h"
#include "Acceleration/FieldStructures.h"
#include "Acceleration/TileBounds.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// Which samples changed from one frame to the next, told by their fingerprints alone: those of the
/// last frame may be gone.
///
/// Data that never changes is not hashed. So the first change cannot be told.
class SampleComparer
{
public:
  enum class Result : std::uint8_t
  {
    Unknown,
    Equal,
    Different
  };

  /// Compare the samples of the last frame with those of the next one, which are hashed.
  /// \throws std::bad_alloc
  Result Compare(const Field& last, const Field& next, FieldStructures& shared);

  /// Find the tiles in which samples that were found to be different can be seen.
  /// \param ranges of the samples of the next frame
  /// \throws std::bad_alloc
  void FindTilesToTrace(
    const View& view, const IndexTransform& transform, const FieldRanges& ranges);

  /// True if no sample that is different can be seen in a tile.
  /// \pre ShareToTrace() < 1
  bool CanCopy(std::int64_t tile) const
  {
    return !this->TilesToTrace[static_cast<std::size_t>(tile)];
  }

  /// Share of the tiles that are not like those of the last frame, as far as is known.
  double ShareToTrace() const;

  /// The last frame is one of these samples now.
  /// \param ranges those of the frame, or of other samples where it has none
  void Take(const Field& shown, const FieldRanges& ranges);

  /// The last frame is one of the samples that were compared, and equal.
  void TakeEqual() { this->Last = this->Next; }

private:
  /// What all samples together change of how each is read.
  struct Limits
  {
    glm::dvec2 FiniteRange{ 0.0 };
    bool AreFinite = false;
  };

  static Limits LimitsOf(const FieldRanges& ranges);
  static bool AreReadAlike(const Limits& a, const Limits& b);

  std::shared_ptr<const FieldFingerprint> Last, Next; ///< null: not hashed
  Limits LimitsOfLast;
  std::vector<CellBox> Changed;
  std::vector<std::uint8_t> TilesToTrace; ///< 1 or 0; empty: all
};

}

#endif
