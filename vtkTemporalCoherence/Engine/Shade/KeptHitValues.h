// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KeptHitValues_h
#define TemporalCoherence_KeptHitValues_h

#include "Scene/Frame.h"
#include "Scene/FrameKey.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

struct HitList;

/// Keeps the values of an array at the hits of the last frame, so that other colours of them read
/// no samples: eight bytes a pixel. Only of opaque surfaces, whose pixels have one hit each. The
/// first frame with an array keeps nothing, as storing takes time.
class KeptHitValues
{
public:
  /// Begin a frame. What is kept is forgotten if the frame shows other hits or another array.
  /// \param areHitsOfLast the frame has the hits of the frame before
  /// \return true if there are values to keep
  /// \throws std::bad_alloc
  bool Begin(const FrameKey& key, bool areHitsOfLast);

  /// Find the values at all hits of a tile, row by row. Thread-safe for different tiles.
  /// \param key of the frame that was begun
  void Find(const FrameKey& key, std::int64_t tile, HitList& hits);

private:
  std::shared_ptr<const ArrayValues> Of;
  Plane<double> Values;               ///< of each tile, in the order of its hits
  std::vector<std::uint8_t> AreKnown; ///< those of each tile
};

}

#endif
