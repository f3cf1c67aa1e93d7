// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SegmentBreaks_h
#define TemporalCoherence_SegmentBreaks_h

#include "Volumes/Samples/ComponentSegment.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

/// The shares that cut a segment into parts with a smooth look.
class SegmentBreaks
{
public:
  /// With more bends in a cell, equal parts replace them.
  static constexpr std::size_t MostBends = 24;
  static constexpr std::size_t EvenParts = 32;

  explicit SegmentBreaks(const ComponentSegment& segment)
    : Segment(segment)
  {
    this->Add(0.0);
    this->Add(1.0);
    for (std::size_t step = 1; segment.IsNearest && step < segment.Nearest.Count; ++step)
    {
      this->Add(segment.Nearest.Shares[step]);
    }
  }

  /// Add the shares at which a component takes one of some values, ascending.
  void AddBends(std::size_t component, const std::vector<double>& bends)
  {
    if (this->Segment.IsNearest)
    {
      return;
    }
    const Cubic<double>& cubic = this->Segment.Cubics[component];
    const auto [low, high] = std::minmax_element(cubic.begin(), cubic.end());
    const auto first = std::upper_bound(bends.begin(), bends.end(), *low);
    const auto last = std::lower_bound(first, bends.end(), *high);
    if (static_cast<std::size_t>(last - first) > MostBends)
    {
      this->HasEvenParts = true;
      for (std::size_t i = 1; i < EvenParts; ++i)
      {
        this->Add(static_cast<double>(i) / EvenParts);
      }
      return;
    }
    for (auto bend = first; bend != last; ++bend)
    {
      Cubic<double> difference = cubic;
      for (double& coefficient : difference)
      {
        coefficient -= *bend;
      }
      VisitCrossings(difference,
        [this](double share)
        {
          this->Add(share);
          return false;
        });
    }
  }

  /// True if there were too many bends, so that parts may contain bends.
  bool AreEven() const { return this->HasEvenParts; }

  /// Call visit(from, to) for each part, ascending.
  template <typename Visit>
  void ForEachPart(const Visit& visit)
  {
    std::sort(
      this->Shares.begin(), this->Shares.begin() + static_cast<std::ptrdiff_t>(this->Count));
    for (std::size_t i = 1; i < this->Count; ++i)
    {
      if (this->Shares[i - 1] < this->Shares[i])
      {
        visit(this->Shares[i - 1], this->Shares[i]);
      }
    }
  }

private:
  void Add(double share)
  {
    if (this->Count < this->Shares.size())
    {
      this->Shares[this->Count++] = share;
    }
  }

  const ComponentSegment& Segment;
  std::size_t Count = 0;
  bool HasEvenParts = false;
  /// Each bend may be crossed three times; four components and the range of an average.
  std::array<double, 5 * 3 * MostBends + 8> Shares;
};

}

#endif
