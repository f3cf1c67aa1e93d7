// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bricks/BrickCache.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// Bricks that are dropped together, as a share of all: finding the oldest looks at all.
constexpr std::size_t ShareToDrop = 16;

constexpr std::size_t MostAwaited = 1 << 16;

}

BrickCache::BrickCache(
  const glm::ivec3& dimensions, std::size_t sampleSize, std::shared_ptr<const BrickReader> reader)
  : Dimensions(dimensions)
  , Grid((dimensions - 1) / Cells + 1)
  , BytesOfBrick(sampleSize * Edge * Edge * Edge)
  , BytesOfSample(sampleSize)
  , Reader(std::move(reader))
  , Entries(new Entry[static_cast<std::size_t>(this->Grid.x) *
      static_cast<std::size_t>(this->Grid.y) * static_cast<std::size_t>(this->Grid.z)])
  , Blank(this->BytesOfBrick)
{
}

BrickCache::~BrickCache()
{
  for (const std::int64_t brick : this->Held)
  {
    delete[] this->Entries[static_cast<std::size_t>(brick)].Samples.load();
  }
  for (const std::byte* room : this->Free)
  {
    delete[] room;
  }
}

void BrickCache::SetLimit(std::size_t bytes) const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->MostRooms = bytes / this->BytesOfBrick;
  if (this->Rooms > this->MostRooms)
  {
    this->DropBefore(SampleUse::Oldest());
  }
}

bool BrickCache::IsTooLate() const
{
  const std::int64_t deadline = this->Deadline.load();
  return deadline != Patient &&
    std::chrono::steady_clock::now().time_since_epoch() >= std::chrono::nanoseconds(deadline);
}

/// Get a brick that was not there.
const std::byte* BrickCache::Await(std::int64_t brick) const
{
  Entry& entry = this->Entries[static_cast<std::size_t>(brick)];
  std::unique_lock<std::mutex> lock(this->Guard);
  while (true)
  {
    if (const std::byte* const samples = entry.Samples.load())
    {
      return samples;
    }
    if (this->IsTooLate())
    {
      SampleUse::Miss();
      return this->Blank.data();
    }
    if (std::find(this->BeingRead.begin(), this->BeingRead.end(), brick) == this->BeingRead.end())
    {
      break;
    }
    this->HasRead.wait(lock);
  }
  std::byte* room = this->MakeRoom(SampleUse::Oldest());
  if (!room)
  {
    room = new std::byte[this->BytesOfBrick]; // a tile needs more than the limit
    ++this->Rooms;
  }
  if (this->Awaited.size() < MostAwaited)
  {
    this->Awaited.push_back(brick);
  }
  this->ReadInto(brick, room, SampleUse::Now(), lock);
  return room;
}

bool BrickCache::ReadAhead(std::int64_t brick, std::uint64_t since) const
{
  Entry& entry = this->Entries[static_cast<std::size_t>(brick)];
  std::unique_lock<std::mutex> lock(this->Guard);
  if (entry.Samples.load() ||
    std::find(this->BeingRead.begin(), this->BeingRead.end(), brick) != this->BeingRead.end())
  {
    return true;
  }
  std::byte* const room = this->MakeRoom(std::min(since, SampleUse::Oldest()));
  if (!room)
  {
    return false;
  }
  this->ReadInto(brick, room, since, lock);
  return true;
}

/// Room for a brick within the limit; null if there is none.
/// \param before bricks used before this time may be dropped
std::byte* BrickCache::MakeRoom(std::uint64_t before) const
{
  if (this->Free.empty() && this->Rooms < this->MostRooms)
  {
    ++this->Rooms;
    return new std::byte[this->BytesOfBrick];
  }
  if (this->Free.empty())
  {
    this->DropBefore(before);
  }
  if (this->Free.empty())
  {
    return nullptr;
  }
  std::byte* const room = this->Free.back();
  this->Free.pop_back();
  return room;
}

/// Drop some of the bricks that were not used at a time or later, the oldest first.
void BrickCache::DropBefore(std::uint64_t time) const
{
  const auto stampOf = [this](std::int64_t brick)
  { return this->Entries[static_cast<std::size_t>(brick)].Stamp.load(); };
  std::vector<std::pair<std::uint64_t, std::int64_t>> old;
  for (const std::int64_t brick : this->Held)
  {
    if (stampOf(brick) < time)
    {
      old.emplace_back(stampOf(brick), brick);
    }
  }
  const std::size_t excess = this->Rooms > this->MostRooms ? this->Rooms - this->MostRooms : 0;
  const std::size_t count = std::min(old.size(), excess + this->Held.size() / ShareToDrop + 1);
  std::partial_sort(old.begin(), old.begin() + static_cast<std::ptrdiff_t>(count), old.end());
  std::vector<std::int64_t> dropped;
  for (std::size_t i = 0; i < count; ++i)
  {
    Entry& entry = this->Entries[static_cast<std::size_t>(old[i].second)];
    std::byte* const samples = entry.Samples.exchange(nullptr);
    if (entry.Stamp.load() >= time)
    {
      entry.Samples.store(samples); // a reader came in between
      continue;
    }
    dropped.push_back(old[i].second);
    if (this->Rooms > this->MostRooms)
    {
      delete[] samples;
      --this->Rooms;
    }
    else
    {
      this->Free.push_back(samples);
    }
  }
  std::sort(dropped.begin(), dropped.end());
  this->Held.erase(std::remove_if(this->Held.begin(), this->Held.end(),
                     [&](std::int64_t brick)
                     { return std::binary_search(dropped.begin(), dropped.end(), brick); }),
    this->Held.end());
}

/// Read a brick, and let others find it.
/// \param room  for the brick
/// \param stamp time of its last use
/// \param lock  of Guard; others may take it while the brick is read
/// \throws std::bad_alloc; the brick is not there then
void BrickCache::ReadInto(std::int64_t brick, std::byte* room, std::uint64_t stamp,
  std::unique_lock<std::mutex>& lock) const
{
  const glm::ivec3 begin = this->FirstCellOf(brick) - Before;
  const glm::ivec3 first = glm::max(begin, glm::ivec3(0));
  const glm::ivec3 end = glm::min(begin + Edge, this->Dimensions);
  const glm::ivec3 skipped = first - begin;
  const std::int64_t at = skipped.x + Edge * (skipped.y + Edge * skipped.z);
  this->BeingRead.push_back(brick);
  bool isRead = false;
  lock.unlock();
  try
  {
    this->Reader->Read(first, end - first,
      room + at * static_cast<std::int64_t>(this->BytesOfSample), { Edge, Edge * Edge });
    isRead = true;
  }
  catch (const std::bad_alloc&)
  {
  }
  lock.lock();
  this->BeingRead.erase(std::find(this->BeingRead.begin(), this->BeingRead.end(), brick));
  this->HasRead.notify_all();
  if (!isRead)
  {
    this->Free.push_back(room);
    throw std::bad_alloc();
  }
  ++this->Reads;
  this->Held.push_back(brick);
  Entry& entry = this->Entries[static_cast<std::size_t>(brick)];
  entry.Stamp.store(std::max(stamp, entry.Stamp.load()));
  entry.Samples.store(room);
}

std::vector<std::int64_t> BrickCache::TakeAwaited() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return std::exchange(this->Awaited, {});
}

std::vector<std::int64_t> BrickCache::Around(std::int64_t brick) const
{
  const glm::ivec3 place = this->FirstCellOf(brick) / Cells;
  const glm::ivec3 low = glm::max(place - 1, glm::ivec3(0));
  const glm::ivec3 high = glm::min(place + 1, this->Grid - 1);
  std::vector<std::int64_t> around;
  for (int z = low.z; z <= high.z; ++z)
  {
    for (int y = low.y; y <= high.y; ++y)
    {
      for (int x = low.x; x <= high.x; ++x)
      {
        around.push_back(this->PlaceOf(Cells * glm::ivec3(x, y, z)).Brick);
      }
    }
  }
  return around;
}

glm::ivec3 BrickCache::FirstCellOf(std::int64_t brick) const
{
  const std::int64_t row = brick / this->Grid.x;
  return Cells * glm::ivec3(brick % this->Grid.x, row % this->Grid.y, row / this->Grid.y);
}

std::size_t BrickCache::MemoryInBytes() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  const std::size_t entries = static_cast<std::size_t>(this->Grid.x) *
    static_cast<std::size_t>(this->Grid.y) * static_cast<std::size_t>(this->Grid.z);
  return this->Rooms * this->BytesOfBrick + entries * sizeof(Entry);
}

}
