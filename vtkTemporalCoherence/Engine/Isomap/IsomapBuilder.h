// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_IsomapBuilder_h
#define TemporalCoherence_IsomapBuilder_h

#include "Acceleration/LeafHistogram.h"
#include "Acceleration/ValueRangePyramid.h"
#include "ImageCache/ImageCache.h"
#include "Isomap/BandPlan.h"
#include "Isomap/Isomap.h"
#include "Scene/FrameKey.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// Builds the isomap of one view, band by band as isovalues need them.
class IsomapBuilder
{
public:
  /// The isomap of the view in which isovalues last changed.
  const Isomap& Built() const { return this->Map; }

  /// True if there is a band for each isovalue of a frame.
  bool Covers(const FrameKey& key, const Isomap::Options& options) const
  {
    return this->Map.IsOf(key, options) && this->Map.Covers(key.Isosurfaces.Isovalues) &&
      !IsTooCoarse(key, options);
  }

  /// True if building bands for a frame may succeed.
  bool CanBuild(const FrameKey& key, const Isomap::Options& options) const;

  /// The cost of a frame without an isomap.
  struct ColdFrame
  {
    std::int64_t CellsRead = 0;
    Surfaces Isosurfaces;
  };

  /// Build the missing bands for a frame.
  /// \param last frame: the isovalues that a drag comes from, and where rays may start
  /// \throws std::bad_alloc
  Isomap::Outcome Build(const FrameKey& key, const Isomap::Options& options,
    const CachedImage& last, const ValueRangePyramid& pyramid, const ColdFrame& cold,
    const ReportProgress& report);

  /// Cells that the last call of Build read.
  std::int64_t CellsRead() const { return this->Cells; }

  /// The bands for the isovalues of a frame. \pre Covers(key)
  std::vector<const Isomap::Band*> BandsFor(const FrameKey& key);

  /// True if the memory limit was too low for the bands that were needed last.
  bool IsTooLarge() const { return this->FailedLimit > 0; }

  /// Build no more bands for this view: memory ran out.
  void GiveUp() { this->FailedLimit = std::numeric_limits<std::size_t>::max(); }

  /// Begin anew if the bands for a frame do not hold the range that the options ask for.
  void DropNarrowBands(
    const FrameKey& key, const Isomap::Options& options, const ValueRangePyramid& pyramid);

  /// Drop bands until they take at most this many bytes.
  void Trim(std::size_t limit) { this->Map.Trim(limit); }

  /// Reassign the isomap from the field `before` to `now`, whose samples are equal but lie
  /// elsewhere.
  void MoveTo(const Field& now, const Field& before) { this->Map.MoveTo(now, before); }

  /// The data has changed.
  void Release() { *this = IsomapBuilder(); }

private:
  /// What bands are built from.
  struct Context
  {
    const Isomap::Options& Options;
    const std::vector<double>& IsovaluesBefore;
    const ValueRangePyramid& Pyramid;
    const ColdFrame& Cold;
    const ReportProgress& Report;
  };

  /// True if layers behind a looked-up surface could not be found: its distance is not exact.
  static bool IsTooCoarse(const FrameKey& key, const Isomap::Options& options)
  {
    return Isomap::FormFor(key, options).Tolerance > 0.0 && key.Isosurfaces.IsTranslucent();
  }

  std::int64_t ColdCellsAt(double isovalue, const ColdFrame& cold) const;
  Isomap::Outcome BuildFor(double isovalue, const Context& context);
  BandPlan::Wish WishFor(double isovalue, const std::vector<double>& before) const;

  Isomap Map;
  BandPlan Plan;
  LeafHistogram Leaves;        ///< of the data's pyramid; made on first use
  std::size_t FailedLimit = 0; ///< memory limit that not even a narrow band fitted
  std::int64_t Cells = 0;
};

}

#endif
