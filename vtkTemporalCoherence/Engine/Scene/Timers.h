// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Timers_h
#define TemporalCoherence_Timers_h

#include <chrono>
#include <cstdint>

namespace TemporalCoherence
{

/// Adds its lifetime to a number of seconds.
class Stopwatch
{
public:
  explicit Stopwatch(double& seconds)
    : Seconds(seconds)
    , Begin(std::chrono::steady_clock::now())
  {
  }
  ~Stopwatch()
  {
    const auto now = std::chrono::steady_clock::now();
    this->Seconds += std::chrono::duration<double>(now - this->Begin).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

private:
  double& Seconds;
  std::chrono::steady_clock::time_point Begin;
};

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
