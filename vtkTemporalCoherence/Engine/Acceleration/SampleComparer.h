// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SampleComparer_h
#define TemporalCoherence_SampleComparer_h

#include "Acceleration/FieldFingerprint.h"
#include "Acceleration/FieldStructures.h"
#include "Scene/View.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// Tells which samples changed since the last frame. It compares fingerprints, as the samples of
/// the last frame may be gone.
///
/// Data that never changes is not hashed, so the first change cannot be located. Labels always are.
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

  /// Find the tiles that the changed samples can affect.
  /// \param ranges of the samples of the next frame
  /// \throws std::bad_alloc
  void FindTilesToTrace(
    const View& view, const IndexTransform& transform, const FieldRanges& ranges);

  /// True if no changed sample affects a tile.
  /// \pre ShareToTrace() < 1
  bool CanCopy(std::int64_t tile) const
  {
    return !this->TilesToTrace[static_cast<std::size_t>(tile)];
  }

  /// The share of tiles to trace: 1 if it is not known what changed.
  double ShareToTrace() const;

  /// The last frame shows these samples now.
  /// \param ranges of the frame; of other samples if it has none
  void Take(const Field& shown, const FieldRanges& ranges);

  /// The last frame shows the samples that were just compared and found equal.
  void TakeEqual() { this->Last = this->Next; }

private:
  /// Properties of all samples together that affect how each sample is read.
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
