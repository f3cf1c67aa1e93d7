// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_Measuring_h
#define Benchmarks_Measuring_h

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <limits>
#include <stdexcept>
#include <vector>

/// Times and what is made of many of them.
namespace Measuring
{

/// A measurement that cannot be made; the text is one sentence for the user.
struct Failure : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Stands for a figure that there is not; tables show "-" for it, JSON null.
constexpr double None = std::numeric_limits<double>::quiet_NaN();

/// Milliseconds of wall time that an action takes.
template <typename Action>
double TimeOf(const Action& action)
{
  const auto begin = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
    .count();
}

/// Milliseconds of processor time of all threads so far.
inline double CpuTime()
{
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The middle value, the upper one of two; None of none.
inline double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? None : values[values.size() / 2];
}

/// The value that so many percent of the values do not exceed; None of none.
inline double Percentile(std::vector<double> values, int percent)
{
  std::sort(values.begin(), values.end());
  const std::size_t above = values.size() * static_cast<std::size_t>(100 - percent) / 100;
  return values.empty() ? None : values[values.size() - 1 - std::min(above, values.size() - 1)];
}

/// The largest value; 0 of none.
inline double Worst(const std::vector<double>& values)
{
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

/// The average; 0 of none.
inline double Mean(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

/// A quotient; 0 if there is nothing to divide by.
inline double Ratio(double numerator, double denominator)
{
  return denominator == 0.0 ? 0.0 : numerator / denominator;
}

}

#endif
