// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DriftPlot.h"

#include "Measuring.h"
#include "Plots.h"

#include <algorithm>
#include <cmath>

namespace
{

/// Ticks at powers of ten from one below a single pixel, which stands for none, to above the
/// worst.
Plots::Ticks DecadeTicks(double worst, int size)
{
  const double onePixel = 100.0 / (static_cast<double>(size) * size);
  const int none = static_cast<int>(std::floor(std::log10(onePixel)));
  const int top = std::max(none + 1, static_cast<int>(std::ceil(std::log10(worst + onePixel))));
  Plots::Ticks ticks = { { none, "none" } };
  for (int power = none + 1; power <= top; ++power)
  {
    ticks.emplace_back(power, Fixed(std::pow(10.0, power), std::max(0, -power)) + " %");
  }
  return ticks;
}

/// A colour for each speed.
Plots::Series LogarithmOf(const Drift::Curve& curve, int color, double none)
{
  Plots::Series series;
  series.Name = Fixed(curve.Degrees, 1) + " degrees a frame";
  series.Color = color;
  for (std::size_t i = 0; i < curve.Frames.size(); ++i)
  {
    const double different = curve.Different[i];
    series.X.push_back(curve.Frames[i]);
    series.Y.push_back(different > 0.0 ? std::max(none, std::log10(different)) : none);
  }
  return series;
}

}

void PlotDrift(const std::vector<Drift::Curve>& curves, const std::string& volume, int size,
  const std::string& path)
{
  Plots::Chart chart;
  chart.Title = "Drift of pictures each made from the last (PAPER): " + volume;
  chart.XTitle = "Frame";
  chart.YTitle = "Pixels that differ from the cold picture";
  double worst = 0.0;
  for (const Drift::Curve& curve : curves)
  {
    worst = std::max(worst, Measuring::Worst(curve.Different));
  }
  chart.YTicks = DecadeTicks(worst, size);
  for (const Drift::Curve& curve : curves)
  {
    const int color = static_cast<int>(chart.Series.size());
    chart.Series.push_back(LogarithmOf(curve, color, chart.YTicks.front().first));
  }
  Plots::Write(chart, path);
}
