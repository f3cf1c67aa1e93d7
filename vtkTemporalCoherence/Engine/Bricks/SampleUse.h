// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SampleUse_h
#define TemporalCoherence_SampleUse_h

#include <atomic>
#include <cstdint>

namespace TemporalCoherence
{

/// A stretch of work of one thread, such as a tile. In it, addresses of samples that a BrickCache
/// gives to this thread stay valid. One inside of another one on the same thread changes nothing.
///
/// A clock counts the stretches of all threads. Bricks are stamped with it when they are used, so a
/// brick with a stamp before the oldest stretch is needed by nobody (epoch-based reclamation:
/// Fraser 2004).
class SampleUse
{
public:
  SampleUse();
  ~SampleUse();
  SampleUse(const SampleUse&) = delete;
  SampleUse& operator=(const SampleUse&) = delete;

  /// End this thread's stretch and begin another one: addresses from before are no longer valid.
  /// One inside of another goes on.
  static void Renew();

  /// End a stretch that began outside of any SampleUse.
  static void End();

  /// The time of this thread's stretch. Outside of any, one begins that the next SampleUse of this
  /// thread ends.
  static std::uint64_t Begin()
  {
    const std::uint64_t time = Own().Time.load(std::memory_order_relaxed);
    return time != Nothing ? time : BeginHere();
  }

  /// The present time: no stretch has begun later.
  static std::uint64_t Now();

  /// The beginning of the oldest stretch that goes on, or the present time if there is none.
  static std::uint64_t Oldest();

  /// A sample is missing: throw the results of this stretch away.
  static void Miss() { Own().HasMissed = true; }

  /// True if a sample was missing in this thread's stretch.
  static bool HasMissed() { return Own().HasMissed; }

private:
  static constexpr std::uint64_t Nothing = ~std::uint64_t(0);

  /// What others may know of a thread.
  struct Thread
  {
    std::atomic<std::uint64_t> Time{ Nothing }; ///< at which its stretch began
    std::atomic<bool> IsTaken{ true };          ///< by a thread that lives
    int Depth = 0;                              ///< of stretches inside of each other
    bool HasMissed = false;
    Thread* Next = nullptr;
  };
  struct Holder;

  static Thread& Own();
  static std::uint64_t BeginHere();

  static std::atomic<Thread*> Threads;
};

}

#endif
