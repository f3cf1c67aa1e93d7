// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Integral/BlendTruthBreaks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace BlendTruthBreaks
{
namespace
{

/// The coefficients of the cubic with these values at 0, 1/3, 2/3 and 1.
std::array<double, 4> CubicThrough(const std::array<double, 4>& v)
{
  return { v[0], (-11.0 * v[0] + 18.0 * v[1] - 9.0 * v[2] + 2.0 * v[3]) / 2.0,
    9.0 * (2.0 * v[0] - 5.0 * v[1] + 4.0 * v[2] - v[3]) / 2.0,
    9.0 * (-v[0] + 3.0 * v[1] - 3.0 * v[2] + v[3]) / 2.0 };
}

/// Where in (0, 1) a cubic turns.
std::vector<double> TurnsOf(const std::array<double, 4>& c)
{
  const double a = 3.0 * c[3], b = 2.0 * c[2], d = c[1];
  const double root = b * b - 4.0 * a * d;
  std::vector<double> turns;
  if (root >= 0.0)
  {
    const double q = -0.5 * (b + std::copysign(std::sqrt(root), b));
    for (const double turn : { a != 0.0 ? q / a : -1.0, q != 0.0 ? d / q : -1.0 })
    {
      if (turn > 0.0 && turn < 1.0)
      {
        turns.push_back(turn);
      }
    }
  }
  std::sort(turns.begin(), turns.end());
  return turns;
}

/// Where a function is largest in a part in which it rises and then falls, by golden sections.
double TopOf(const std::function<double(double)>& valueAt, double low, double high)
{
  constexpr double golden = 0.6180339887498949;
  constexpr int sections = 60;
  for (int section = 0; section < sections; ++section)
  {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    (valueAt(left) < valueAt(right) ? low : high) = valueAt(left) < valueAt(right) ? left : right;
  }
  return 0.5 * (low + high);
}

/// Add the turns, and between each two of them, where the function passes bends.
void AddBetween(const std::function<double(double)>& valueAt, const std::vector<double>& turns,
  const std::vector<double>& bends, std::vector<double>& breaks)
{
  breaks.insert(breaks.end(), turns.begin(), turns.end());
  for (std::size_t i = 1; i < turns.size(); ++i)
  {
    const double from = valueAt(turns[i - 1]), to = valueAt(turns[i]);
    auto bend = std::upper_bound(bends.begin(), bends.end(), std::min(from, to));
    for (; bend != bends.end() && *bend < std::max(from, to); ++bend)
    {
      double low = turns[i - 1], high = turns[i];
      for (double middle = 0.5 * (low + high); low < middle && middle < high;
           middle = 0.5 * (low + high))
      {
        ((valueAt(middle) < *bend) == (from < to) ? low : high) = middle;
      }
      breaks.push_back(high);
    }
  }
}

}

void AddOfCubic(const std::function<double(double)>& valueAt, const Part& part,
  const std::vector<double>& bends, std::vector<double>& breaks)
{
  const double length = part.End - part.Begin;
  const std::array<double, 4> values{ valueAt(part.Begin), valueAt(part.Begin + length / 3.0),
    valueAt(part.End - length / 3.0), valueAt(part.End) };
  std::vector<double> turns{ part.Begin };
  for (const double turn : TurnsOf(CubicThrough(values)))
  {
    turns.push_back(part.Begin + turn * length);
  }
  turns.push_back(part.End);
  AddBetween(valueAt, turns, bends, breaks);
}

void AddOfSmooth(const std::function<double(double)>& valueAt, const Part& part,
  const std::vector<double>& bends, std::vector<double>& breaks)
{
  constexpr std::size_t pieces = 64;
  std::array<double, pieces + 1> at, values;
  for (std::size_t i = 0; i <= pieces; ++i)
  {
    at[i] = part.Begin + (part.End - part.Begin) * static_cast<double>(i) / pieces;
    values[i] = valueAt(at[i]);
  }
  std::vector<double> turns{ part.Begin };
  for (std::size_t i = 1; i < pieces; ++i)
  {
    const double before = values[i] - values[i - 1], behind = values[i + 1] - values[i];
    if (before * behind < 0.0)
    {
      const double sign = before > 0.0 ? 1.0 : -1.0;
      turns.push_back(TopOf([&](double t) { return sign * valueAt(t); }, at[i - 1], at[i + 1]));
    }
  }
  turns.push_back(part.End);
  std::sort(turns.begin(), turns.end());
  AddBetween(valueAt, turns, bends, breaks);
}

}
