// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/GroupCosts.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

float Positive(std::int64_t cost)
{
  return static_cast<float>(std::max<std::int64_t>(cost, 1));
}

}

void GroupCosts::Resize(std::size_t groups)
{
  if (this->Groups.size() != groups)
  {
    this->Groups.assign(groups, Cost());
  }
}

void GroupCosts::SetTraced(std::size_t group, std::int64_t cost)
{
  this->Groups[group] = Cost();
  this->Groups[group].Traced = Positive(cost);
}

void GroupCosts::SetLookedUp(std::size_t group, std::int64_t cost)
{
  Cost& known = this->Groups[group];
  if (known.Traced == 0.0f)
  {
    return;
  }
  known.LookedUpLast = Positive(cost);
  if (known.LookedUpFirst == 0.0f)
  {
    known.TracedFirst = known.Traced;
    known.LookedUpFirst = known.LookedUpLast;
  }
  known.Traced =
    0.5f * (known.Traced + known.TracedFirst / known.LookedUpFirst * known.LookedUpLast);
}

/// What the sum of the costs of groups that are looked up is to be divided by. Each is the quotient
/// of noisy numbers, which is too large on average.
double GroupCosts::Excess() const
{
  double now = 0.0, tracedFirst = 0.0, first = 0.0, last = 0.0;
  for (const Cost& cost : this->Groups)
  {
    if (cost.LookedUpFirst > 0.0f)
    {
      now += static_cast<double>(cost.Traced);
      tracedFirst += static_cast<double>(cost.TracedFirst);
      first += static_cast<double>(cost.LookedUpFirst);
      last += static_cast<double>(cost.LookedUpLast);
    }
  }
  return now > 0.0 ? now * first / (tracedFirst * last) : 1.0;
}

bool GroupCosts::AreKnown() const
{
  return std::any_of(
    this->Groups.begin(), this->Groups.end(), [](const Cost& cost) { return cost.Traced > 0.0f; });
}

std::vector<double> GroupCosts::All() const
{
  const double excess = this->Excess();
  std::vector<double> costs;
  double sum = 0.0;
  std::size_t count = 0;
  for (const Cost& cost : this->Groups)
  {
    const auto traced = static_cast<double>(cost.Traced);
    costs.push_back(cost.LookedUpFirst > 0.0f ? traced / excess : traced);
    sum += costs.back();
    count += cost.Traced > 0.0f;
  }
  const double mean = count > 0 ? sum / static_cast<double>(count) : 1.0;
  std::replace(costs.begin(), costs.end(), 0.0, mean);
  return costs;
}

}
