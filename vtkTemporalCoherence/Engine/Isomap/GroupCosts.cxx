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
  this->Groups[group] = { Positive(cost), 0.0f };
}

void GroupCosts::SetLookedUp(std::size_t group, std::int64_t cost)
{
  Cost& known = this->Groups[group];
  if (known.Traced == 0.0f)
  {
    return;
  }
  if (known.ByLookUp == 0.0f)
  {
    known.ByLookUp = known.Traced / Positive(cost);
    return;
  }
  // Single measurements are noisy.
  known.Traced = 0.5f * (known.Traced + known.ByLookUp * Positive(cost));
}

bool GroupCosts::AreKnown() const
{
  return std::any_of(
    this->Groups.begin(), this->Groups.end(), [](const Cost& cost) { return cost.Traced > 0.0f; });
}

std::vector<double> GroupCosts::All() const
{
  double sum = 0.0;
  std::size_t count = 0;
  for (const Cost& cost : this->Groups)
  {
    sum += static_cast<double>(cost.Traced);
    count += cost.Traced > 0.0f;
  }
  const double mean = count > 0 ? sum / static_cast<double>(count) : 1.0;
  std::vector<double> costs;
  for (const Cost& cost : this->Groups)
  {
    costs.push_back(cost.Traced > 0.0f ? static_cast<double>(cost.Traced) : mean);
  }
  return costs;
}

}
