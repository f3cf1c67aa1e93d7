// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BrickCache_h
#define TemporalCoherence_BrickCache_h

#include "Bricks/BrickReader.h"
#include "Bricks/SampleUse.h"

#include <glm/glm.hpp>

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace TemporalCoherence
{

/// The samples of a volume, in bricks that are read when they are needed, and dropped when memory
/// is short: the least recently used ones first.
///
/// A brick owns 32^3 cells. Gradients also need neighbours: a layer of samples before the cells,
/// and two layers behind. The brick holds these, too. So code with the address of a cell's first
/// sample finds all samples that the cell needs at constant strides.
class BrickCache
{
public:
  static constexpr int Cells = 32; ///< of a brick along each axis
  static constexpr int Before = 1; ///< samples before the first cell
  static constexpr int Edge = 35;  ///< samples along each axis

  /// \param dimensions samples of the volume along each axis
  /// \param sampleSize bytes of a sample
  /// \throws std::bad_alloc
  BrickCache(const glm::ivec3& dimensions, std::size_t sampleSize,
    std::shared_ptr<const BrickReader> reader);
  ~BrickCache();
  BrickCache(const BrickCache&) = delete;
  BrickCache& operator=(const BrickCache&) = delete;

  /// Samples from one to the next along x, y and z within a brick.
  static glm::i64vec3 Strides() { return { 1, Edge, Edge * Edge }; }

  /// The address of a sample; valid until this thread's SampleUse ends. Reads a missing brick.
  /// Strides reach the neighbouring samples from here: one before, two behind along each axis.
  template <typename T>
  const T* At(int i, int j, int k) const
  {
    const Place place = this->PlaceOf({ i, j, k });
    return reinterpret_cast<const T*>(this->Find(place.Brick)) + place.Sample;
  }

  /// The bytes that bricks may take; at least those that a tile needs are kept, whatever this says.
  void SetLimit(std::size_t bytes) const;

  /// From this time on, missing bricks are not read: zeros are given for their samples, and
  /// SampleUse::HasMissed tells so.
  /// \param time of std::chrono::steady_clock since its epoch, in ns; Patient: wait for all bricks
  void GiveUpAt(std::int64_t time) const { this->Deadline.store(time); }
  static constexpr std::int64_t Patient = -1;

  /// A frame begins: its bricks count as those of the last frame.
  void BeginFrame() const { this->FrameBegin = ++this->Clock; }

  /// Read a missing brick, unless that would drop a brick of the last frame.
  /// \return false if memory is short
  bool ReadAhead(std::int64_t brick) const;

  /// The bricks that were read, and whose reading somebody waited for, since the last call.
  std::vector<std::int64_t> TakeAwaited() const;

  /// True if a brick is there now.
  bool Has(std::int64_t brick) const
  {
    return this->Entries[static_cast<std::size_t>(brick)].Samples.load() != nullptr;
  }

  /// The brick and its neighbours, at most 27 bricks.
  std::vector<std::int64_t> Around(std::int64_t brick) const;

  /// The first cell of a brick.
  glm::ivec3 FirstCellOf(std::int64_t brick) const;

  std::size_t MemoryInBytes() const;

  /// How often bricks were read.
  std::int64_t NumberOfReads() const { return this->Reads.load(); }

private:
  struct Place
  {
    std::int64_t Brick;
    std::int64_t Sample;
  };

  Place PlaceOf(const glm::ivec3& sample) const
  {
    static_assert(Cells == 32, "shifts and masks say so");
    const std::int64_t brick = (sample.x >> 5) +
      static_cast<std::int64_t>(this->Grid.x) *
        ((sample.y >> 5) + static_cast<std::int64_t>(this->Grid.y) * (sample.z >> 5));
    const std::int64_t inside = (sample.x & 31) + Before +
      Edge * ((sample.y & 31) + Before + Edge * ((sample.z & 31) + Before));
    return { brick, inside };
  }

  /// A place for a brick. Threads list the brick (SampleUse) before they read the address.
  struct Entry
  {
    std::atomic<std::byte*> Samples{ nullptr };
    std::atomic<std::uint64_t> LastUse{ 0 }; ///< by Clock
  };

  const std::byte* Find(std::int64_t brick) const
  {
    SampleUse::Hold(this, brick);
    Entry& entry = this->Entries[static_cast<std::size_t>(brick)];
    const std::uint64_t now = this->Clock.load(std::memory_order_relaxed);
    if (entry.LastUse.load(std::memory_order_relaxed) != now)
    {
      entry.LastUse.store(now, std::memory_order_relaxed);
    }
    const std::byte* const samples = entry.Samples.load();
    return samples ? samples : this->Await(brick);
  }

  bool IsTooLate() const;
  const std::byte* Await(std::int64_t brick) const;
  std::byte* MakeRoom(bool keepsFrame) const;
  void Drop(bool keepsFrame) const;
  void ReadInto(std::int64_t brick, std::byte* room, std::unique_lock<std::mutex>& lock) const;

  glm::ivec3 Dimensions, Grid;
  std::size_t BytesOfBrick;
  std::size_t BytesOfSample;
  std::shared_ptr<const BrickReader> Reader;
  std::unique_ptr<Entry[]> Entries;
  std::vector<std::byte> Blank; ///< given where samples are missing
  mutable std::atomic<std::int64_t> Deadline{ Patient };
  mutable std::atomic<std::int64_t> Reads{ 0 };
  mutable std::atomic<std::uint64_t> Clock{ 1 }; ///< goes on with each brick that is read
  mutable std::atomic<std::uint64_t> FrameBegin{ 1 };

  /// Guards what follows.
  mutable std::mutex Guard;
  mutable std::condition_variable HasRead;
  mutable std::vector<std::int64_t> Held; ///< bricks that are there
  mutable std::vector<std::int64_t> BeingRead;
  mutable std::vector<std::byte*> Free; ///< rooms for bricks
  mutable std::vector<std::int64_t> Awaited;
  mutable std::size_t MostRooms = 0;
  mutable std::size_t Rooms = 0; ///< that are in use or free
};

}

#endif
