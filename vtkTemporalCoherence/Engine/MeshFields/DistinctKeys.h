// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_DistinctKeys_h
#define TemporalCoherence_DistinctKeys_h

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// A list of at most 64 different keys, each found by hashing: the cells of the rays of a tile.
class DistinctKeys
{
public:
  static constexpr std::size_t Most = 64;

  DistinctKeys() { this->Slots.fill(None); }

  /// \return where a key is in the list; it is appended if it is new
  std::size_t Add(std::uint64_t key)
  {
    auto slot = static_cast<std::size_t>(key * 0x9E3779B97F4A7C15u >> 56);
    while (this->Slots[slot] != None && this->Keys[this->Slots[slot]] != key)
    {
      slot = (slot + 1) % this->Slots.size();
    }
    // Whether a key is new is not predictable, so there is no branch.
    const bool isNew = this->Slots[slot] == None;
    const std::size_t place = isNew ? this->Number : this->Slots[slot];
    this->Slots[slot] = static_cast<std::uint8_t>(place);
    this->Keys[place] = key;
    this->Number += isNew;
    return place;
  }

  std::size_t Count() const { return this->Number; }
  std::uint64_t operator[](std::size_t place) const { return this->Keys[place]; }

private:
  static constexpr std::uint8_t None = 255;

  std::array<std::uint8_t, 256> Slots; ///< places of keys, by their hash
  std::array<std::uint64_t, Most> Keys;
  std::size_t Number = 0;
};

}

#endif
