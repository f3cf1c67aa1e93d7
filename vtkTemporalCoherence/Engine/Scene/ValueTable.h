// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ValueTable_h
#define TemporalCoherence_ValueTable_h

#include <algorithm>
#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

/// Looks of values: colours or opacities. Bounds divide the values into segments, each of which has
/// the same number of even intervals. In an interval the look changes linearly; between intervals
/// it may jump.
/// \tparam Look float, or a vector of floats
template <typename Look>
class ValueTable
{
public:
  struct Interval
  {
    Look First, Last; ///< at its two ends
  };

  /// Looks where there is no interval.
  struct OtherLooks
  {
    Look Below, Above; ///< beyond the bounds
    Look Missing;      ///< where there is no value
  };

  /// \param bounds    ascending, at least two
  /// \param intervals a positive multiple of the number of segments
  ValueTable(const std::vector<double>& bounds, const std::vector<Interval>& intervals,
    const OtherLooks& others);

  Look At(double value) const
  {
    if (!(value >= this->Bounds.front() && value <= this->Bounds.back()))
    {
      return value < this->Bounds.front() ? this->Others.Below
        : value > this->Bounds.back()     ? this->Others.Above
                                          : this->Others.Missing;
    }
    const auto next = std::upper_bound(this->Bounds.begin() + 1, this->Bounds.end() - 1, value);
    const auto segment = static_cast<std::size_t>(next - this->Bounds.begin()) - 1;
    // As vtkLookupTable multiplies, so that whole numbers find the same looks.
    const double place = std::min(static_cast<double>(this->InSegment),
      (value - this->Bounds[segment]) * this->PerValue[segment]);
    const std::size_t interval = std::min(static_cast<std::size_t>(place), this->InSegment - 1);
    const Change& in = this->Changes[segment * this->InSegment + interval];
    return in.First + static_cast<float>(place - static_cast<double>(interval)) * in.Rise;
  }

  /// True if all values look like this.
  bool IsAll(const Look& look) const;

  bool IsSame(const ValueTable& other) const;

private:
  /// The look in an interval.
  struct Change
  {
    Look First, Rise; ///< at its beginning; from there to its end
  };

  std::vector<double> Bounds;
  std::vector<double> PerValue; ///< intervals, in each segment
  std::size_t InSegment;        ///< intervals
  std::vector<Change> Changes;
  OtherLooks Others;
};

}

#endif
