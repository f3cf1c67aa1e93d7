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

/// The finisher of splitmix64: each bit depends on all.
inline std::uint64_t MixBits(std::uint64_t bits)
{
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

/// Numbers of points that cells share, by names: points of the data set with whole numbers as
/// weights. So neighbours find the same point without comparing coordinates.
class SharedPoints
{
public:
  using Name = std::vector<std::pair<std::int64_t, std::int64_t>>; ///< point, weight; in any order

  /// 128 bits of a name. Two names with the same bits are taken to be equal: in 10^9 names, the
  /// chance is 1e-21.
  struct Key
  {
    std::uint64_t First, Second;
  };

  /// \param name is sorted, and its equal points are merged
  static Key KeyOf(Name& name);

  /// Have memory bring what Find needs.
  void Prefetch(const Key& key) const
  {
    if (!this->Entries.empty())
    {
      hwy::Prefetch(
        this->Entries.data() + (static_cast<std::size_t>(key.First) & (this->Entries.size() - 1)));
    }
  }

  /// The number of the point with this name. If it is new, it gets the number given.
  /// \throws std::bad_alloc
  std::int32_t Find(const Key& key, std::int32_t ifNew);
  std::int32_t Find(Name& name, std::int32_t ifNew) { return this->Find(KeyOf(name), ifNew); }

  /// Of a point of the data set.
  std::int32_t Find(std::int64_t point, std::int32_t ifNew);

  std::size_t MemoryInBytes() const { return this->Entries.size() * sizeof(Entry); }

private:
  struct Entry
  {
    Key Bits;
    std::int32_t Number = -1; ///< of no point
  };

  Entry& EntryOf(const Key& key);
  void Grow();

  std::vector<Entry> Entries; ///< as many as a power of two; at most half of them are used
  std::size_t Used = 0;
};

}

#endif
