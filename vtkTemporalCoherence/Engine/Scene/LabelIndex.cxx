// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/LabelIndex.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

/// The largest range of labels that has a table.
constexpr std::uint64_t MostPlaces = std::uint64_t(1) << 20;

}

LabelIndex::LabelIndex(const std::vector<double>& labels)
{
  if (labels.empty())
  {
    return;
  }
  const auto [least, most] = std::minmax_element(labels.begin(), labels.end());
  this->Lowest = static_cast<std::int64_t>(*least);
  const std::uint64_t range = static_cast<std::uint64_t>(static_cast<std::int64_t>(*most)) -
    static_cast<std::uint64_t>(this->Lowest);
  if (range < MostPlaces)
  {
    this->Places.assign(static_cast<std::size_t>(range) + 1, Frame::NoSurface);
  }
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    const auto label = static_cast<std::int64_t>(labels[i]);
    const auto position = static_cast<SurfaceIndex>(i);
    if (range < MostPlaces)
    {
      this->Places[static_cast<std::size_t>(label - this->Lowest)] = position;
    }
    else
    {
      this->Sorted.emplace_back(label, position);
    }
  }
  std::sort(this->Sorted.begin(), this->Sorted.end());
}

SurfaceIndex LabelIndex::Search(std::int64_t label) const
{
  const auto found = std::lower_bound(this->Sorted.begin(), this->Sorted.end(), label,
    [](const auto& entry, std::int64_t wanted) { return entry.first < wanted; });
  return found != this->Sorted.end() && found->first == label ? found->second : Frame::NoSurface;
}

}
