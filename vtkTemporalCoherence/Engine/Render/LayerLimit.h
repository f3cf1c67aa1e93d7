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
  std::size_t OfPixel = MostKeptLayers; ///< the most of a pixel: a power of two
  /// The most memory of all layers of a frame, in bytes. If they took more, half as many are kept
  /// of each pixel, or a quarter, and so on, but at least one.
  std::size_t Bytes = std::size_t(256) << 20;
};

/// Limits the layers that a frame keeps while threads make it. Which limit its pixels have in the
/// end depends on the picture alone. Meanwhile it only falls, so that memory is bounded throughout.
class LayerLimit
{
public:
  /// \param frame begun, and not yet made
  /// \throws std::bad_alloc
  LayerLimit(const LayerOptions& options, Frame& frame);

  /// Count the layers of a tile that is made, and merge them if the frame has too many. Thread-safe
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
  bool IsNeeded;                         ///< the layers may be too many
  std::atomic<std::int64_t> Total{ 0 };  ///< layers of all tiles, before any are merged here
  std::atomic<std::int64_t> Behind{ 0 }; ///< those that no light reaches
  std::vector<std::uint8_t> IsCounted;   ///< 1 for each tile that Kept knows
  std::array<std::atomic<std::int64_t>, Levels> Kept{}; ///< by these tiles, if this were the level
  std::atomic<std::int64_t> Merged{ 0 };
};

/// True if the layers of a tile are those that a frame with other tiles would keep.
/// \param frame a finished one
bool KeepsAllLayers(std::int64_t tile, const Frame& frame, const LayerOptions& options);

}

#endif
