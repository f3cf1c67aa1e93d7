// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/Light/LightCache.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <iterator>
#include <new>

namespace TemporalCoherence
{
namespace
{

/// Bytes of a block: its place, its patches, and two slots.
constexpr std::size_t BytesOfBlock = 36 + 256 + 2 * sizeof(std::uint32_t);

/// True if two lights cast the same soft shadows. Hard ones are found anew in each frame.
bool CastAlike(const Light& a, const Light& b)
{
  const bool areSoft = a.CastsSoftShadows();
  return areSoft == b.CastsSoftShadows() && (!areSoft || (a.Size == b.Size && ShineAlike(a, b)));
}

}

/// Drop all other blocks.
template <typename IsKept>
void LightCache::KeepOnly(const IsKept& isKept)
{
  std::size_t count = 0;
  for (std::size_t block = 0; block < this->Blocks.size(); ++block)
  {
    if (isKept(this->Blocks[block]))
    {
      this->Blocks[count] = this->Blocks[block];
      this->Blocks[count].Larger = NoBlock;
      this->Sums[count] = this->Sums[block];
      ++count;
    }
  }
  this->Blocks.resize(count);
  this->Sums.resize(count);
  this->Resize(this->Slots.size());
  this->Frames = count == 0 ? 0 : this->Frames;
}

void LightCache::Follow(const FrameKey& key)
{
  if (!(this->Of.Samples == key.Samples) || !(this->Of.Transform == key.Transform) ||
    !(this->Of.Region == key.Region) || !(this->Of.Isosurfaces == key.Isosurfaces()))
  {
    this->Clear();
    this->Of = { key.Samples, key.Transform, key.Region, key.Isosurfaces() };
  }
  const std::vector<Light>& lights = key.Appearance.Lights;
  const double radius = key.Appearance.Occlusion.Radius;
  std::vector<bool> isKept(std::max(this->Lights.size(), lights.size()) + 1);
  isKept[0] = this->Radius == radius;
  for (std::size_t i = 0; i < std::min(this->Lights.size(), lights.size()); ++i)
  {
    isKept[i + 1] = CastAlike(this->Lights[i], lights[i]);
  }
  if (std::find(isKept.begin(), isKept.end(), false) != isKept.end())
  {
    this->KeepOnly([&](const Block& block) { return isKept[block.Place.Source]; });
  }
  this->Radius = radius;
  this->Lights = lights;
}

void LightCache::PrepareSlot(std::uint64_t hash) const
{
  if (!this->Slots.empty())
  {
    hwy::Prefetch(&this->Slots[hash & (this->Slots.size() - 1)]);
  }
}

void LightCache::PrepareBlock(std::uint64_t hash, const PatchPlace& place) const
{
  if (this->Slots.empty())
  {
    return;
  }
  const std::uint32_t block = this->Slots[hash & (this->Slots.size() - 1)];
  if (block != NoBlock)
  {
    hwy::Prefetch(&this->Blocks[block]);
    hwy::Prefetch(&this->Sums[block][place.Patch]);
  }
}

std::uint32_t LightCache::FindBlock(std::uint64_t hash, const PatchPlace& place) const
{
  if (this->Slots.empty())
  {
    return NoBlock;
  }
  const std::size_t mask = this->Slots.size() - 1;
  for (std::size_t slot = hash & mask;; slot = (slot + 1) & mask)
  {
    const std::uint32_t block = this->Slots[slot];
    if (block == NoBlock || AreTogether(this->Blocks[block].Place, place))
    {
      return block;
    }
  }
}

LightCache::Known LightCache::Find(std::uint64_t hash, const PatchPlace& place) const
{
  Known known;
  known.Block = this->FindBlock(hash, place);
  if (known.Block != NoBlock)
  {
    known.Own = this->Sums[known.Block][place.Patch];
  }
  if (known.Own.Rays() >= FewRays)
  {
    return known;
  }
  std::uint32_t block = known.Block;
  PatchPlace at = place;
  for (LightSum& larger : known.Larger)
  {
    at = LargerThan(at);
    block = block == NoBlock || this->Blocks[block].Larger == NoBlock
      ? this->FindBlock(HashOfBlock(at), at)
      : this->Blocks[block].Larger;
    if (block != NoBlock)
    {
      larger = this->Sums[block][at.Patch];
    }
  }
  return known;
}

void LightCache::Insert(std::uint32_t block)
{
  const std::size_t mask = this->Slots.size() - 1;
  std::size_t slot = HashOfBlock(this->Blocks[block].Place) & mask;
  while (this->Slots[slot] != NoBlock)
  {
    slot = (slot + 1) & mask;
  }
  this->Slots[slot] = block;
}

void LightCache::Resize(std::size_t slots)
{
  this->Slots.assign(slots, NoBlock);
  for (std::uint32_t block = 0; block < this->Blocks.size(); ++block)
  {
    this->Insert(block);
  }
}

/// The position of the block of a place. A new block is appended.
/// \pre there are slots (ReserveFor)
std::uint32_t LightCache::ProvideBlock(const PatchPlace& place)
{
  const std::uint32_t known = this->FindBlock(HashOfBlock(place), place);
  if (known != NoBlock)
  {
    return known;
  }
  if (2 * (this->Blocks.size() + 1) > this->Slots.size())
  {
    this->Resize(2 * this->Slots.size());
  }
  Block block{ place, NoBlock, this->Frames };
  block.Place.Patch = 0;
  this->Blocks.push_back(block);
  this->Sums.emplace_back();
  const auto at = static_cast<std::uint32_t>(this->Blocks.size() - 1);
  this->Insert(at);
  return at;
}

/// Add rays to a patch. The first rays of a patch also count for larger patches.
void LightCache::Add(const Found& found)
{
  PatchPlace place = found.Place;
  std::uint32_t block = found.Block == NoBlock ? this->ProvideBlock(place) : found.Block;
  const bool areFew = this->Sums[block][place.Patch].Rays() < FewRays;
  for (std::size_t size = 0;; ++size)
  {
    this->Sums[block][place.Patch].Add(found.Rays, found.Light);
    this->Blocks[block].LastSeen = this->Frames;
    if (!areFew || size == LargerSizes)
    {
      return;
    }
    place = LargerThan(place);
    if (this->Blocks[block].Larger == NoBlock)
    {
      const std::uint32_t larger = this->ProvideBlock(place); // may move the blocks
      this->Blocks[block].Larger = larger;
    }
    block = this->Blocks[block].Larger;
  }
}

/// Make room for the blocks that new patches need.
void LightCache::ReserveFor(const FoundInTiles& tiles)
{
  std::size_t patches = 0;
  for (const std::vector<Found>& tile : tiles)
  {
    patches += static_cast<std::size_t>(std::count_if(tile.begin(), tile.end(),
      [](const Found& found) { return found.Rays > 0 && found.Block == NoBlock; }));
  }
  // A block of a surface has more than ten patches, of which half are new in the same frame.
  constexpr std::size_t newOfBlock = 5;
  const std::size_t blocks = this->Blocks.size() + patches / newOfBlock;
  if (blocks > this->Blocks.capacity())
  {
    this->Blocks.reserve(blocks + blocks / 2);
    this->Sums.reserve(blocks + blocks / 2);
  }
  std::size_t slots = std::max<std::size_t>(this->Slots.size(), 1024);
  while (slots < 2 * blocks)
  {
    slots *= 2;
  }
  if (slots > this->Slots.size())
  {
    this->Resize(slots);
  }
}

void LightCache::Add(const FoundInTiles& tiles, std::size_t mostBytes)
{
  ++this->Frames;
  try
  {
    this->ReserveFor(tiles);
    for (const std::vector<Found>& tile : tiles)
    {
      for (const Found& found : tile)
      {
        if (found.Rays > 0)
        {
          this->Add(found);
        }
        else if (found.Block != NoBlock)
        {
          this->Blocks[found.Block].LastSeen = this->Frames;
        }
      }
    }
    if (this->Bytes() > mostBytes)
    {
      this->Drop(mostBytes);
    }
  }
  catch (const std::bad_alloc&)
  {
    this->Clear();
  }
}

std::size_t LightCache::Bytes() const
{
  static_assert(sizeof(Block) + sizeof(Patches) <= BytesOfBlock);
  return this->Blocks.size() * BytesOfBlock;
}

/// Drop the blocks that were not seen for the longest time, until half of the memory is free.
/// Blocks of the last frame stay: a still picture needs them to become final.
void LightCache::Drop(std::size_t mostBytes)
{
  const auto ageOf = [this](const Block& block) { return this->Frames - block.LastSeen; };
  std::vector<std::uint32_t> ages;
  ages.reserve(this->Blocks.size());
  std::transform(this->Blocks.begin(), this->Blocks.end(), std::back_inserter(ages), ageOf);
  const std::size_t kept = mostBytes / 2 / BytesOfBlock;
  if (kept >= ages.size())
  {
    return;
  }
  std::nth_element(ages.begin(), ages.begin() + static_cast<std::ptrdiff_t>(kept), ages.end());
  const std::uint32_t oldest = std::max(ages[kept], 1u);
  this->KeepOnly([&](const Block& block) { return ageOf(block) < oldest; });
}

void LightCache::Clear()
{
  *this = LightCache();
}

}
