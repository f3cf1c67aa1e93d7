// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KeptLabels_h
#define TemporalCoherence_KeptLabels_h

#include "Render/Routes.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// What the rays of the last frame met that stays when other labels are drawn. Thread-safe.
class KeptLabels
{
public:
  /// \param task    outlives this. Active cells are prepared, if its rays leap
  /// \param changes of samples since the last frame
  /// \throws std::bad_alloc
  KeptLabels(const FrameTask& task, const SampleComparer& changes);

  /// The picture whose rays meet nothing before their old hit; null: they may.
  const Frame* Before() const { return this->HasAdded || this->Changes ? nullptr : &this->Last; }

  /// One bit for each pixel of a tile, row by row, whose ray must be traced: it met a label that is
  /// gone, or may meet another one earlier.
  std::uint64_t ToTrace(std::int64_t tile, const PixelRect& part) const;

  /// Copy a tile. The answers of its pixels become definite.
  /// \param traced pixels that are written later: they do not count
  TraceCounts Copy(
    std::int64_t tile, const PixelRect& part, std::uint64_t traced, Frame& frame) const;

private:
  std::size_t PlaceOf(int x, int y) const;
  SurfaceIndex SurfaceNow(std::size_t pixel) const;

  const Frame& Last;
  const SampleComparer* Changes; ///< null: no sample changed
  bool IsParallel;
  std::vector<SurfaceIndex> IndexNow; ///< of the last frame's surfaces
  bool HasAdded = false;
  /// For each tile, the distance from which on its rays may meet added labels; infinity: nowhere.
  std::vector<double> NearestAdded;
};

}

#endif
