// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ArrayColors_h
#define TemporalCoherence_ArrayColors_h

#include "Scene/HitRays.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// Colours of values. Bounds divide the values into segments, each of which has the same number of
/// even intervals. In an interval the colour changes linearly; between intervals it may jump.
struct ValueColors
{
  struct Interval
  {
    glm::vec3 First{ 0.0f }, Last{ 0.0f }; ///< RGB in [0, 1] at its two ends
  };

  std::vector<double> Bounds;             ///< ascending, at least two
  std::vector<Interval> Intervals;        ///< a positive multiple of the number of segments
  glm::vec3 Below{ 0.0f }, Above{ 0.0f }; ///< beyond the bounds
  glm::vec3 Missing{ 0.0f };              ///< where there is no value

  glm::vec3 At(double value) const
  {
    if (!(value >= this->Bounds.front() && value <= this->Bounds.back()))
    {
      return value < this->Bounds.front() ? this->Below
        : value > this->Bounds.back()     ? this->Above
                                          : this->Missing;
    }
    const auto next = std::upper_bound(this->Bounds.begin() + 1, this->Bounds.end() - 1, value);
    const auto segment = static_cast<std::size_t>(next - this->Bounds.begin()) - 1;
    const std::size_t count = this->Intervals.size() / (this->Bounds.size() - 1);
    // As vtkLookupTable multiplies, so that whole numbers find the same colours.
    const double perValue = static_cast<double>(count) / (*next - *(next - 1));
    const double from = value - *(next - 1);
    const double place = from > 0.0 ? std::min(from * perValue, static_cast<double>(count)) : 0.0;
    const std::size_t interval = std::min(static_cast<std::size_t>(place), count - 1);
    const Interval& in = this->Intervals[segment * count + interval];
    const auto weight = static_cast<float>(place - static_cast<double>(interval));
    return in.First + weight * (in.Last - in.First);
  }
};

inline bool operator==(const ValueColors::Interval& a, const ValueColors::Interval& b)
{
  return a.First == b.First && a.Last == b.Last;
}

inline bool operator==(const ValueColors& a, const ValueColors& b)
{
  return a.Bounds == b.Bounds && a.Intervals == b.Intervals && a.Below == b.Below &&
    a.Above == b.Above && a.Missing == b.Missing;
}

/// An array on the data whose surfaces are drawn.
class ArrayValues
{
public:
  virtual ~ArrayValues() = default;

  /// True if two arrays are equal.
  virtual bool IsSame(const ArrayValues& other) const = 0;

  /// Find the values at hits, as the data are interpolated. NaN: there is no value. Thread-safe.
  /// \param cells of a mesh that are hit, or NoCell
  virtual void Find(const HitRays& rays, const RayBatch::Array<CellNumber>& cells,
    RayBatch::Array<double>& values) const = 0;
};

/// Colours of surfaces by the values of an array.
struct ArrayColors
{
  std::shared_ptr<const ArrayValues> Values;
  std::shared_ptr<const ValueColors> Colors;
};

/// True if two pointers, which may be null, point to equal colours.
inline bool AreSame(
  const std::shared_ptr<const ArrayColors>& a, const std::shared_ptr<const ArrayColors>& b)
{
  return a == b ||
    (a && b && a->Values->IsSame(*b->Values) &&
      (a->Colors == b->Colors || *a->Colors == *b->Colors));
}

}

#endif
