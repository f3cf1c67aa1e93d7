// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/GroupCosts.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

// Measured by the mean and the worst frames of drags along which cold frames become cheaper,
// `Benchmark --scenarios drags --views close bonsai.vti 40`.

/// What groups told that were traced after look-ups counts half after so much of the picture was
/// traced.
constexpr double HalfLife = 0.03;

/// What look-ups tell alone counts as much as so much of the picture.
constexpr double WeightOfLookUps = 0.003;

/// What tracing costs more or less from frame to frame, compared with look-ups, counts half if so
/// much of the picture was traced.
constexpr double LeastTraced = 0.02;

/// Look-ups that cost so many times more or less than at first are old.
constexpr double MostChange = 1.1;

/// A group that took so many times more than expected was interrupted.
constexpr double MostOfGuess = 4.0;

float Positive(std::int64_t cost)
{
  return static_cast<float>(std::max<std::int64_t>(cost, 1));
}

}

void GroupCosts::Resize(std::size_t groups)
{
  if (this->Groups.size() != groups)
  {
    this->Forget();
    this->Groups.assign(groups, Cost());
  }
}

void GroupCosts::SetTraced(std::size_t group, std::int64_t cost)
{
  Cost& known = this->Groups[group];
  const bool isGuess = known.LookedUpFirst > 0.0f;
  const float before = isGuess ? 0.0f : known.Traced;
  const float guessed = isGuess ? static_cast<float>(this->GuessOf(known)) : 0.0f;
  known = Cost();
  known.Traced = Positive(cost);
  known.Before = before;
  known.Guessed = guessed;
  known.IsNew = true;
}

void GroupCosts::SetLookedUp(std::size_t group, std::int64_t cost)
{
  Cost& known = this->Groups[group];
  if (known.Traced == 0.0f)
  {
    return;
  }
  known.LookedUpBefore = known.LookedUpLast;
  known.LookedUpLast = Positive(cost);
  if (known.LookedUpFirst == 0.0f)
  {
    known.TracedFirst = known.Traced;
    known.LookedUpFirst = known.LookedUpLast;
    known.TrendFirst = static_cast<float>(this->Trend);
  }
  known.Traced =
    0.5f * (known.Traced + known.TracedFirst / known.LookedUpFirst * known.LookedUpLast);
}

void GroupCosts::Learn()
{
  double all = 0.0, traced = 0.0, guessed = 0.0, measured = 0.0;
  for (Cost& cost : this->Groups)
  {
    const auto now = static_cast<double>(cost.Traced), before = static_cast<double>(cost.Guessed);
    all += now;
    traced += cost.IsNew ? now : 0.0;
    if (cost.IsNew && before > 0.0)
    {
      guessed += before;
      measured += std::min(now, MostOfGuess * before);
    }
    cost.IsNew = false;
    cost.Guessed = 0.0f;
  }
  this->FollowTrend(all);
  const double left = all > 0.0 ? std::exp2(-traced / all / HalfLife) : 0.0;
  this->Guessed = left * this->Guessed + guessed;
  this->Measured = left * this->Measured + measured;
}

/// \param all what tracing all groups costs
void GroupCosts::FollowTrend(double all)
{
  double before = 0.0, now = 0.0, lookedUpBefore = 0.0, lookedUp = 0.0;
  for (Cost& cost : this->Groups)
  {
    if (cost.Before > 0.0f)
    {
      before += static_cast<double>(cost.Before);
      now +=
        std::min(static_cast<double>(cost.Traced), MostOfGuess * static_cast<double>(cost.Before));
    }
    if (cost.LookedUpBefore > 0.0f)
    {
      lookedUpBefore += static_cast<double>(cost.LookedUpBefore);
      lookedUp += static_cast<double>(cost.LookedUpLast);
    }
    cost.Before = cost.LookedUpBefore = 0.0f;
  }
  if (before > 0.0 && lookedUpBefore > 0.0)
  {
    const double change = now / before * lookedUpBefore / lookedUp;
    const double weight = before / (before + LeastTraced * all);
    this->Trend *= std::pow(std::clamp(change, 0.5, 2.0), weight);
  }
}

/// What tracing a group costs that is looked up: as its look-ups and the trend tell.
double GroupCosts::GuessOf(const Cost& cost) const
{
  return static_cast<double>(cost.Traced) * this->Trend / static_cast<double>(cost.TrendFirst);
}

GroupCosts::Sums GroupCosts::OfGuesses() const
{
  Sums sums;
  for (const Cost& cost : this->Groups)
  {
    if (cost.LookedUpFirst > 0.0f)
    {
      sums.Now += this->GuessOf(cost);
      sums.TracedFirst += static_cast<double>(cost.TracedFirst);
      sums.ByTrend +=
        static_cast<double>(cost.TracedFirst) * this->Trend / static_cast<double>(cost.TrendFirst);
      sums.LookedUpFirst += static_cast<double>(cost.LookedUpFirst);
      sums.LookedUpLast += static_cast<double>(cost.LookedUpLast);
    }
  }
  return sums;
}

/// What the costs of groups that are looked up are to be multiplied by. Each is the quotient of
/// noisy numbers, which is too large on average; and tracing need not follow look-ups. Where these
/// become cheaper, tracing is taken to become so by as much again, at least, until some groups are
/// traced: who spends what it saves must not take it for too dear.
double GroupCosts::Correction() const
{
  const Sums sums = this->OfGuesses();
  if (!(sums.Now > 0.0))
  {
    return 1.0;
  }
  const double change = sums.LookedUpLast / sums.LookedUpFirst;
  const double traced =
    change < 1.0 ? std::min(sums.ByTrend, sums.TracedFirst * change) : sums.ByTrend;
  const double byLookUps = traced * change / sums.Now;
  const double weight = WeightOfLookUps * sums.Now;
  return (weight * byLookUps + this->Measured) / (weight + this->Guessed);
}

bool GroupCosts::AreOld() const
{
  const Sums sums = this->OfGuesses();
  return sums.LookedUpLast > MostChange * sums.LookedUpFirst ||
    sums.LookedUpFirst > MostChange * sums.LookedUpLast;
}

bool GroupCosts::AreKnown() const
{
  return std::any_of(
    this->Groups.begin(), this->Groups.end(), [](const Cost& cost) { return cost.Traced > 0.0f; });
}

std::vector<double> GroupCosts::All() const
{
  const double correction = this->Correction();
  std::vector<double> costs;
  double sum = 0.0;
  std::size_t count = 0;
  for (const Cost& cost : this->Groups)
  {
    costs.push_back(cost.LookedUpFirst > 0.0f ? this->GuessOf(cost) * correction
                                              : static_cast<double>(cost.Traced));
    sum += costs.back();
    count += cost.Traced > 0.0f;
  }
  const double mean = count > 0 ? sum / static_cast<double>(count) : 1.0;
  std::replace(costs.begin(), costs.end(), 0.0, mean);
  return costs;
}

}
