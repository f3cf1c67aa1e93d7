// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ChunkCache_h
#define TemporalCoherence_ChunkCache_h

#include "VolumeFiles/VolumeFile.h"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace TemporalCoherence
{

/// The decoded chunks of one level of a volume that were read last. Threads share them: each chunk
/// is decoded once, however many wait for it.
class ChunkCache
{
public:
  /// \param limit bytes that chunks may take. Those that are being read do not count
  ChunkCache(std::shared_ptr<const VolumeFile> file, std::size_t level, std::size_t limit);

  const VolumeLevel& Level() const { return this->File->Levels()[this->LevelNumber]; }

  /// The samples of a chunk. Those of a chunk that cannot be read are zeros. Thread-safe.
  /// \param chunk position in the grid of chunks
  /// \throws std::bad_alloc
  std::shared_ptr<const std::byte> Get(const glm::ivec3& chunk);

  void SetLimit(std::size_t limit);

  /// The mistake in the first unreadable chunk; empty: all chunks were readable.
  std::string Mistake() const;

  /// How many chunks could not be read.
  std::size_t NumberOfMistakes() const;

  std::size_t MemoryInBytes() const;

private:
  using Samples = std::shared_ptr<const std::byte>;
  struct Held
  {
    Samples Chunk; ///< null: being read
    std::list<std::int64_t>::iterator Place;
  };

  /// Rooms of dropped chunks, for new ones: they are large, and all alike.
  struct Rooms
  {
    std::mutex Guard;
    std::vector<std::unique_ptr<std::byte[]>> Free;
  };

  std::shared_ptr<std::byte> MakeRoom() const;
  Samples Read(const glm::ivec3& chunk, std::string& error) const;
  void Drop(std::size_t limit);

  std::shared_ptr<const VolumeFile> File;
  std::size_t LevelNumber;
  std::size_t BytesOfChunk;
  std::shared_ptr<Rooms> Spare = std::make_shared<Rooms>();

  mutable std::mutex Guard; ///< of what follows
  std::condition_variable HasRead;
  std::size_t Limit;
  std::unordered_map<std::int64_t, Held> Chunks;
  std::list<std::int64_t> LastUsed; ///< of chunks that are there, the newest first
  std::string FirstMistake;
  std::set<std::int64_t> Unreadable; ///< chunks
};

}

#endif
