// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SharedPoints_h
#define TemporalCoherence_SharedPoints_h

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <hwy/cache_control.h>

namespace TemporalCoherence
{

/// The finisher of splitmix64: each bit of the result depends on all bits.
inline std::uint64_t MixBits(std::uint64_t bits)
{
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

/// Numbers points that cells share. The name of a point consists of data set points with integer
/// weights. So neighbours find a common point without comparing coordinates.
class SharedPoints
{
public:
  using Name = std::vector<std::pair<std::int64_t, std::int64_t>>; ///< point, weight; in any order

  /// A hash of a name. Equal hashes count as equal names: the chance of a collision among 10^9
  /// names is 1e-21.
  struct Key
  {
    std::uint64_t First, Second;
  };

  /// \param name is sorted, and its equal points are merged
  static Key KeyOf(Name& name);

  /// Prefetch the memory that Find reads.
  void Prefetch(const Key& key) const
  {
    if (!this->Entries.empty())
    {
      hwy::Prefetch(
        this->Entries.data() + (static_cast<std::size_t>(key.First) & (this->Entries.size() - 1)));
    }
  }

  /// The number of the point with this name. A new point gets the number `ifNew`.
  /// \throws std::bad_alloc
  std::int32_t Find(const Key& key, std::int32_t ifNew);
  std::int32_t Find(Name& name, std::int32_t ifNew) { return this->Find(KeyOf(name), ifNew); }

  /// The number of a point of the data set.
  std::int32_t Find(std::int64_t point, std::int32_t ifNew);

  std::size_t MemoryInBytes() const { return this->Entries.size() * sizeof(Entry); }

private:
  struct Entry
  {
    Key Bits;
    std::int32_t Number = -1; ///< -1: unused entry
  };

  Entry& EntryOf(const Key& key);
  void Grow();

  std::vector<Entry> Entries; ///< the size is a power of two; at most half of them are used
  std::size_t Used = 0;
};

}

#endif
