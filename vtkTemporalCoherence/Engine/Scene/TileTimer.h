// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileTimer_h
#define TemporalCoherence_TileTimer_h

#include <chrono>
#include <cstdint>

namespace TemporalCoherence
{

/// Adds its lifetime to a number of nanoseconds, but only in one of several tiles: reading the
/// clock costs as much as a ray, so the stages of a frame are timed by sampling.
class TileTimer
{
public:
  TileTimer(std::int64_t tile, std::int64_t& nanoseconds)
    : Nanoseconds(tile % TimedTiles == 0 ? &nanoseconds : nullptr)
    , Begin(this->Nanoseconds ? Now() : 0)
  {
  }
  ~TileTimer()
  {
    if (this->Nanoseconds)
    {
      *this->Nanoseconds += Now() - this->Begin;
    }
  }
  TileTimer(const TileTimer&) = delete;
  TileTimer& operator=(const TileTimer&) = delete;

  /// Nanoseconds of a clock.
  static std::int64_t Now()
  {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
      std::chrono::steady_clock::now().time_since_epoch())
      .count();
  }

private:
  static constexpr std::int64_t TimedTiles = 31;

  std::int64_t* Nanoseconds;
  std::int64_t Begin;
};

}

#endif
