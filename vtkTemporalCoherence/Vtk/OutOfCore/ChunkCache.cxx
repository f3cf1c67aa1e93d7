// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutOfCore/ChunkCache.h"

#include <algorithm>
#include <new>
#include <utility>

namespace TemporalCoherence
{

ChunkCache::ChunkCache(std::shared_ptr<const VolumeFile> file, std::size_t level, std::size_t limit)
  : File(std::move(file))
  , LevelNumber(level)
  , BytesOfChunk(this->Level().SamplesOfChunk() * SizeOf(this->File->Type()))
  , Limit(limit)
{
  constexpr std::size_t most = 8; // about as many as are read at a time
  this->Spare->Free.reserve(std::clamp(limit / this->BytesOfChunk, std::size_t(1), most));
}

std::shared_ptr<const std::byte> ChunkCache::Get(const glm::ivec3& chunk)
{
  const glm::ivec3 grid = this->Level().NumberOfChunks();
  const std::int64_t number = chunk.x +
    static_cast<std::int64_t>(grid.x) * (chunk.y + static_cast<std::int64_t>(grid.y) * chunk.z);
  std::unique_lock<std::mutex> lock(this->Guard);
  while (true)
  {
    const auto found = this->Chunks.find(number);
    if (found == this->Chunks.end())
    {
      break;
    }
    if (found->second.Chunk)
    {
      this->LastUsed.splice(this->LastUsed.begin(), this->LastUsed, found->second.Place);
      return found->second.Chunk;
    }
    this->HasRead.wait(lock);
  }
  this->Chunks.emplace(number, Held());
  lock.unlock();
  try
  {
    std::string error;
    const Samples samples = this->Read(chunk, error);
    lock.lock();
    if (!error.empty())
    {
      this->FirstMistake = this->Unreadable.empty() ? error : this->FirstMistake;
      this->Unreadable.insert(number);
    }
    this->LastUsed.push_front(number);
    this->Chunks[number] = { samples, this->LastUsed.begin() };
    this->Drop(std::max(this->Limit, this->BytesOfChunk));
    this->HasRead.notify_all();
    return samples;
  }
  catch (const std::bad_alloc&)
  {
    if (!lock.owns_lock())
    {
      lock.lock();
    }
    this->Chunks.erase(number); // whoever waits for it tries again
    this->HasRead.notify_all();
    throw;
  }
}

/// Room for a chunk. It becomes spare when nobody uses it.
std::shared_ptr<std::byte> ChunkCache::MakeRoom() const
{
  std::unique_ptr<std::byte[]> room;
  {
    const std::lock_guard<std::mutex> lock(this->Spare->Guard);
    if (!this->Spare->Free.empty())
    {
      room = std::move(this->Spare->Free.back());
      this->Spare->Free.pop_back();
    }
  }
  if (!room)
  {
    room.reset(new std::byte[this->BytesOfChunk]);
  }
  std::byte* const first = room.get();
  const auto owner = std::make_shared<std::unique_ptr<std::byte[]>>(std::move(room));
  return { first,
    [owner, spare = this->Spare](std::byte*)
    {
      const std::lock_guard<std::mutex> lock(spare->Guard);
      if (spare->Free.size() < spare->Free.capacity())
      {
        spare->Free.push_back(std::move(*owner));
      }
    } };
}

/// Read and decode a chunk.
std::shared_ptr<const std::byte> ChunkCache::Read(const glm::ivec3& chunk, std::string& error) const
{
  const std::shared_ptr<std::byte> samples = this->MakeRoom();
  if (!this->File->ReadChunk(this->LevelNumber, chunk, samples.get(), error))
  {
    std::fill_n(samples.get(), this->BytesOfChunk, std::byte(0));
    error = error.empty() ? "A chunk of the volume cannot be read." : error;
  }
  else
  {
    error.clear();
  }
  return samples;
}

/// Drop chunks until the others fit into a limit, those first that were not used for longest.
void ChunkCache::Drop(std::size_t limit)
{
  while (this->LastUsed.size() * this->BytesOfChunk > limit)
  {
    this->Chunks.erase(this->LastUsed.back());
    this->LastUsed.pop_back();
  }
}

void ChunkCache::SetLimit(std::size_t limit)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Limit = limit;
  this->Drop(limit);
  const std::lock_guard<std::mutex> lockSpare(this->Spare->Guard);
  this->Spare->Free.clear();
}

std::string ChunkCache::Mistake() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->FirstMistake;
}

std::size_t ChunkCache::NumberOfMistakes() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Unreadable.size();
}

std::size_t ChunkCache::MemoryInBytes() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  const std::lock_guard<std::mutex> lockSpare(this->Spare->Guard);
  return (this->LastUsed.size() + this->Spare->Free.size()) * this->BytesOfChunk;
}

}
