// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SampleUse_h
#define TemporalCoherence_SampleUse_h

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

namespace TemporalCoherence
{

/// A stretch of work of one thread, such as a tile. In it, addresses of samples that a BrickCache
/// gives to this thread stay valid. One inside of another one on the same thread changes nothing.
///
/// A thread lists the bricks that it uses before it reads their addresses. Whoever drops a brick
/// takes the address away first, and then looks into all lists (hazard pointers: Michael 2004).
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

  /// End the use of bricks that this thread read outside of any SampleUse.
  static void End();

  /// This thread is about to use a brick.
  /// \param cache that the brick belongs to
  static void Hold(const void* cache, std::int64_t brick)
  {
    Thread& own = Own();
    Used& place = own.Recent[static_cast<std::size_t>(brick) % own.Recent.size()];
    if (place.Cache != cache || place.Brick != brick || place.Stretch != own.Stretch)
    {
      place = { cache, brick, own.Stretch };
      List(own, cache, brick);
    }
  }

  /// The bricks of a cache that threads use now, in no order.
  /// \throws std::bad_alloc
  static std::vector<std::int64_t> HeldOf(const void* cache);

  /// A sample is missing: throw the results of this stretch away.
  static void Miss() { Own().HasMissed = true; }

  /// True if a sample was missing in this thread's stretch.
  static bool HasMissed() { return Own().HasMissed; }

private:
  struct Used
  {
    const void* Cache;
    std::int64_t Brick;
    std::uint64_t Stretch;
  };

  /// The bricks of a thread, and its own state.
  struct Thread
  {
    std::mutex Guard; ///< of the list
    std::vector<std::pair<const void*, std::int64_t>> Listed;
    std::atomic<bool> IsTaken{ true }; ///< by a thread that lives
    int Depth = 0;                     ///< of stretches inside of each other
    bool HasMissed = false;
    std::uint64_t Stretch = 1;
    std::array<Used, 256> Recent{}; ///< some of those that are listed
    Thread* Next = nullptr;
  };
  struct Holder;

  static Thread& Own();
  static void List(Thread& own, const void* cache, std::int64_t brick);
  static void Forget(Thread& own);

  static std::atomic<Thread*> Threads;
};

}

#endif
