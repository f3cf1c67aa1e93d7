// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ValueTable.h"

#include "Scene/ArrayLooks.h"

#include <glm/glm.hpp>

namespace TemporalCoherence
{

template <typename Look>
ValueTable<Look>::ValueTable(const std::vector<double>& bounds,
  const std::vector<Interval>& intervals, const OtherLooks& others)
  : Bounds(bounds)
  , InSegment(intervals.size() / (bounds.size() - 1))
  , Others(others)
{
  for (std::size_t segment = 1; segment < bounds.size(); ++segment)
  {
    const double width = bounds[segment] - bounds[segment - 1];
    this->PerValue.push_back(width > 0.0 ? static_cast<double>(this->InSegment) / width : 0.0);
  }
  for (const Interval& interval : intervals)
  {
    this->Changes.push_back({ interval.First, interval.Last - interval.First });
  }
}

template <typename Look>
bool ValueTable<Look>::IsAll(const Look& look) const
{
  return this->Others.Below == look && this->Others.Above == look && this->Others.Missing == look &&
    std::all_of(this->Changes.begin(), this->Changes.end(),
      [&](const Change& change) { return change.First == look && change.Rise == Look(0.0f); });
}

template <typename Look>
bool ValueTable<Look>::IsSame(const ValueTable& other) const
{
  const auto areSame = [](const Change& a, const Change& b)
  { return a.First == b.First && a.Rise == b.Rise; };
  return this->Bounds == other.Bounds && this->Others.Below == other.Others.Below &&
    this->Others.Above == other.Others.Above && this->Others.Missing == other.Others.Missing &&
    std::equal(this->Changes.begin(), this->Changes.end(), other.Changes.begin(),
      other.Changes.end(), areSame);
}

template <typename Look>
bool AreSame(const ValueTable<Look>& a, const ValueTable<Look>& b)
{
  return a.IsSame(b);
}

template class ValueTable<glm::vec3>;
template class ValueTable<float>;
template bool AreSame(const ValueColors&, const ValueColors&);
template bool AreSame(const ValueOpacities&, const ValueOpacities&);

}
