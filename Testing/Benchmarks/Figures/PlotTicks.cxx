// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plots.h"

#include "Report.h"

#include <algorithm>
#include <cmath>

namespace Plots
{
namespace
{

/// Ticks at 1, 2 and 5 times powers of ten, at their logarithms, from below the smallest to above
/// the largest value.
Ticks LogarithmicTicks(double smallest, double largest)
{
  Ticks ticks;
  for (double decade = std::pow(10.0, std::floor(std::log10(smallest)));; decade *= 10.0)
  {
    for (const double factor : { 1.0, 2.0, 5.0 })
    {
      const double value = factor * decade;
      if (value <= smallest)
      {
        ticks.clear();
      }
      ticks.emplace_back(std::log10(value), Plain(value));
      if (value >= largest && ticks.size() > 1)
      {
        return ticks;
      }
    }
  }
}

}

void SetLogarithmicHeights(Chart& chart)
{
  std::vector<double> heights;
  for (::Plots::Series& series : chart.Series)
  {
    heights.insert(heights.end(), series.Y.begin(), series.Y.end());
    std::transform(
      series.Y.begin(), series.Y.end(), series.Y.begin(), [](double y) { return std::log10(y); });
  }
  const auto [smallest, largest] = std::minmax_element(heights.begin(), heights.end());
  chart.YTicks = LogarithmicTicks(*smallest, *largest);
}

}
