// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SampleChanges_h
#define TemporalCoherence_SampleChanges_h

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace TemporalCoherence
{

/// The samples First .. Last of a field, in index space. There are none if Last < First.
struct SampleBox
{
  glm::ivec3 First{ 0 }, Last{ 0 };

  bool IsEmpty() const { return glm::any(glm::lessThan(this->Last, this->First)); }
};

/// A change of samples in place: between two stamps of a field, none outside of a box changed.
struct SampleChange
{
  std::uint64_t Before, After;
  SampleBox Within;
};

/// The boxes that hold all changes between two stamps; none of them is empty. No list if some
/// change is not known.
inline std::optional<std::vector<SampleBox>> ChangesBetween(
  const std::vector<SampleChange>& changes, std::uint64_t before, std::uint64_t after)
{
  std::vector<SampleBox> boxes;
  while (before != after)
  {
    // A change comes after its stamp, so this ends.
    const auto next = std::find_if(changes.begin(), changes.end(),
      [&](const SampleChange& change) { return change.Before == before && before < change.After; });
    if (next == changes.end())
    {
      return std::nullopt;
    }
    if (!next->Within.IsEmpty())
    {
      boxes.push_back(next->Within);
    }
    before = next->After;
  }
  return boxes;
}

}

#endif
