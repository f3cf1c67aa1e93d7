// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/SharedPoints.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace TemporalCoherence
{
namespace
{

/// Sort a name and merge equal points. After a merge, divide all weights by their common divisor.
void MakeUnique(SharedPoints::Name& name)
{
  std::sort(name.begin(), name.end());
  std::size_t count = 1;
  for (std::size_t i = 1; i < name.size(); ++i)
  {
    if (name[i].first == name[count - 1].first)
    {
      name[count - 1].second += name[i].second;
    }
    else
    {
      name[count++] = name[i];
    }
  }
  if (count == name.size())
  {
    return;
  }
  name.resize(count);
  std::int64_t divisor = 0;
  for (const auto& [point, weight] : name)
  {
    divisor = std::gcd(divisor, weight);
  }
  for (auto& [point, weight] : name)
  {
    weight /= divisor;
  }
}

}

SharedPoints::Key SharedPoints::KeyOf(Name& name)
{
  MakeUnique(name);
  Key key{ 0x9e3779b97f4a7c15u, 0xd1b54a32d192ed03u };
  for (const auto& [point, weight] : name)
  {
    for (const std::int64_t number : { point, weight })
    {
      key.First = MixBits(key.First + static_cast<std::uint64_t>(number) + 0x9e3779b97f4a7c15u);
      key.Second = MixBits((key.Second ^ static_cast<std::uint64_t>(number)) * 0xd6e8feb86659fd93u);
    }
  }
  return key;
}

std::int32_t SharedPoints::Find(std::int64_t point, std::int32_t ifNew)
{
  Name name{ { point, 1 } };
  return this->Find(name, ifNew);
}

std::int32_t SharedPoints::Find(const Key& key, std::int32_t ifNew)
{
  if (2 * (this->Used + 1) > this->Entries.size())
  {
    this->Grow();
  }
  Entry& entry = this->EntryOf(key);
  if (entry.Number < 0)
  {
    entry = { key, ifNew };
    ++this->Used;
  }
  return entry.Number;
}

SharedPoints::Entry& SharedPoints::EntryOf(const Key& key)
{
  const std::size_t mask = this->Entries.size() - 1;
  std::size_t at = static_cast<std::size_t>(key.First) & mask;
  while (this->Entries[at].Number >= 0 &&
    (this->Entries[at].Bits.First != key.First || this->Entries[at].Bits.Second != key.Second))
  {
    at = (at + 1) & mask;
  }
  return this->Entries[at];
}

void SharedPoints::Grow()
{
  constexpr std::size_t smallest = 1024;
  std::vector<Entry> old(std::max(smallest, 2 * this->Entries.size()));
  old.swap(this->Entries);
  for (const Entry& entry : old)
  {
    if (entry.Number >= 0)
    {
      this->EntryOf(entry.Bits) = entry;
    }
  }
}

}
