// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bricks/BrickCache.h"

#include "Bricks/ImpatientWork.h"

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

thread_local int DepthOfImpatience = 0;

}

ImpatientWork::ImpatientWork()
{
  ++DepthOfImpatience;
}

ImpatientWork::~ImpatientWork()
{
  --DepthOfImpatience;
}

bool ImpatientWork::IsHere()
{
  return DepthOfImpatience > 0;
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
  while (this->Rooms > this->MostRooms && !this->Free.empty())
  {
    delete[] this->Free.back();
    this->Free.pop_back();
    --this->Rooms;
  }
  if (this->Rooms > this->MostRooms)
  {
    this->Drop(false);
  }
}

bool BrickCache::IsTooLate() const
{
  const std::int64_t deadline = this->Deadline.load();
  return deadline != Patient && ImpatientWork::IsHere() &&
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
  std::byte* room = this->MakeRoom(false);
  if (!room)
  {
    room = new std::byte[this->BytesOfBrick]; // a tile needs more than the limit
    ++this->Rooms;
  }
  if (this->Awaited.size() < MostAwaited)
  {
    this->Awaited.push_back(brick);
  }
  this->ReadInto(brick, room, lock);
  return room;
}

bool BrickCache::ReadAhead(std::int64_t brick) const
{
  Entry& entry = this->Entries[static_cast<std::size_t>(brick)];
  std::unique_lock<std::mutex> lock(this->Guard);
  if (entry.Samples.load() ||
    std::find(this->BeingRead.begin(), this->BeingRead.end(), brick) != this->BeingRead.end())
  {
    return true;
  }
  std::byte* const room = this->MakeRoom(true);
  if (!room)
  {
    return false;
  }
  entry.LastUse.store(this->FrameBegin.load() - 1);
  this->ReadInto(brick, room, lock);
  return true;
}

/// Room for a brick within the limit; null if there is none.
/// \param keepsFrame bricks of the last frame are not dropped
std::byte* BrickCache::MakeRoom(bool keepsFrame) const
{
  if (this->Free.empty() && this->Rooms < this->MostRooms)
  {
    ++this->Rooms;
    return new std::byte[this->BytesOfBrick];
  }
  if (this->Free.empty())
  {
    this->Drop(keepsFrame);
  }
  if (this->Free.empty())
  {
    return nullptr;
  }
  std::byte* const room = this->Free.back();
  this->Free.pop_back();
  return room;
}

/// Drop some of the bricks that no thread uses, the least recently used ones first.
/// \param keepsFrame bricks of the last frame are not dropped
void BrickCache::Drop(bool keepsFrame) const
{
  const auto entryOf = [this](std::int64_t brick) -> Entry&
  { return this->Entries[static_cast<std::size_t>(brick)]; };
  const auto bricksInUse = [this]()
  {
    std::vector<std::int64_t> bricks = SampleUse::HeldOf(this);
    std::sort(bricks.begin(), bricks.end());
    return bricks;
  };
  const auto isIn = [](const std::vector<std::int64_t>& bricks, std::int64_t brick)
  { return std::binary_search(bricks.begin(), bricks.end(), brick); };

  const std::vector<std::int64_t> before = bricksInUse();
  std::vector<std::pair<std::uint64_t, std::int64_t>> old;
  for (const std::int64_t brick : this->Held)
  {
    const std::uint64_t lastUse = entryOf(brick).LastUse.load();
    if (!isIn(before, brick) && !(keepsFrame && lastUse >= this->FrameBegin.load()))
    {
      old.emplace_back(lastUse, brick);
    }
  }
  const std::size_t excess = this->Rooms > this->MostRooms ? this->Rooms - this->MostRooms : 0;
  const std::size_t count = std::min(old.size(), excess + this->Held.size() / ShareToDrop + 1);
  std::partial_sort(old.begin(), old.begin() + static_cast<std::ptrdiff_t>(count), old.end());
  old.resize(count);

  // Take the addresses away. Threads that came in between have listed their bricks: give these
  // back.
  std::vector<std::byte*> rooms;
  for (const auto& each : old)
  {
    rooms.push_back(entryOf(each.second).Samples.exchange(nullptr));
  }
  const std::vector<std::int64_t> now = bricksInUse();
  for (std::size_t i = 0; i < count; ++i)
  {
    if (isIn(now, old[i].second))
    {
      entryOf(old[i].second).Samples.store(rooms[i]);
    }
    else if (this->Rooms > this->MostRooms)
    {
      delete[] rooms[i];
      --this->Rooms;
    }
    else
    {
      this->Free.push_back(rooms[i]);
    }
  }
  this->Held.erase(std::remove_if(this->Held.begin(), this->Held.end(),
                     [&](std::int64_t brick) { return !entryOf(brick).Samples.load(); }),
    this->Held.end());
}

/// Read a brick, and let others find it.
/// \param room  for the brick
/// \param lock  of Guard; others may take it while the brick is read
/// \throws std::bad_alloc; the brick is not there then
void BrickCache::ReadInto(
  std::int64_t brick, std::byte* room, std::unique_lock<std::mutex>& lock) const
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
  ++this->Clock;
  this->Held.push_back(brick);
  this->Entries[static_cast<std::size_t>(brick)].Samples.store(room);
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
