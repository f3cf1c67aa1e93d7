// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LayerLimit_h
#define TemporalCoherence_LayerLimit_h

#include "Render/FrameStatistics.h"
#include "Scene/Frame.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// How many layers frames keep.
struct LayerOptions
{
  std::size_t OfPixel = MostKeptLayers; ///< limit of a pixel: a power of two
  /// Limit of the memory of all layers of a frame, in bytes. Where it would be exceeded, the limit
  /// of each pixel is halved until the layers fit, down to one layer.
  std::size_t Bytes = std::size_t(256) << 20;
};

/// Limits the layers that a frame keeps while threads make it. The final limit of a pixel depends
/// on the picture alone. Until then the limit only falls, which bounds memory throughout.
class LayerLimit
{
public:
  /// \param frame begun, and not yet made
  /// \throws std::bad_alloc
  LayerLimit(const LayerOptions& options, Frame& frame);

  /// Count the layers of a finished tile, and merge layers if the frame has too many. Thread-safe
  /// for different tiles.
  void Take(std::int64_t tile, Frame& frame);

  /// Merge the layers of all tiles as far as needed. Call this once, when all tiles are made.
  void Finish(Frame& frame, FrameStatistics& statistics);

private:
  static constexpr std::size_t Levels = 6; ///< 32, 16, 8, 4, 2, 1 layers of a pixel

  std::size_t CurrentLevel() const;
  bool AreTooMany() const { return this->Total > this->MostOfFrame; }
  void Count(std::int64_t tile, const Frame& frame);
  void Merge(std::int64_t tile, std::size_t limit, Frame& frame);
  void ForgetBehindIfTooMany(Frame& frame) const;

  std::size_t OfPixel;
  std::int64_t MostOfFrame;
  bool IsNeeded;                         ///< the frame may have too many layers
  std::atomic<std::int64_t> Total{ 0 };  ///< layers of all tiles, before any are merged here
  std::atomic<std::int64_t> Behind{ 0 }; ///< layers that no light reaches
  std::vector<std::uint8_t> IsCounted;   ///< 1 for each tile that Kept includes
  std::array<std::atomic<std::int64_t>, Levels>
    Kept{}; ///< layers of these tiles, if limited to each level
  std::atomic<std::int64_t> Merged{ 0 };
};

/// True if no limit of a frame's memory reduced a tile's layers, so that other frames can copy
/// them.
/// \param frame a finished one
bool KeepsAllLayers(std::int64_t tile, const Frame& frame, const LayerOptions& options);

}

#endif
