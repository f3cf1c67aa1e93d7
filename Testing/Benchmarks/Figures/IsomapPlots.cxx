// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsomapPlots.h"

#include "Measuring.h"
#include "Plots.h"

#include <cmath>
#include <functional>

namespace IsomapPlots
{
namespace
{

using IsomapMaps::Map;
using IsomapReport::Result;

std::string NameOf(const Result& result)
{
  return result.Volume.Name + " " + Plain(result.Volume.Isovalue);
}

/// A quantity of maps, and what its chart is called.
struct Quantity
{
  std::string Title, Axis;
  std::function<double(const Map&)> Of;
};

void AddLine(Plots::Chart& chart, const std::string& name, const std::vector<Map>& maps,
  const std::function<double(const Map&)>& x, const std::function<double(const Map&)>& y)
{
  Plots::Series series;
  series.Name = name;
  const int number = static_cast<int>(chart.Series.size());
  series.Color = number % Plots::NumberOfColors;
  series.IsDashed = number >= Plots::NumberOfColors;
  for (const Map& map : maps)
  {
    if (map.IsBuilt)
    {
      series.X.push_back(x(map));
      series.Y.push_back(y(map));
    }
  }
  chart.Series.push_back(series);
}

/// Both axes of such charts are logarithmic; widths begin at the narrowest band.
Plots::Chart WidthChart(const Quantity& quantity, const std::vector<Result>& results)
{
  Plots::Chart chart;
  chart.Title = quantity.Title;
  chart.XTitle = "Share of the range of values";
  chart.YTitle = quantity.Axis;
  const std::vector<Map>& maps = results.front().Widths;
  const double narrowest = maps.front().Width;
  const auto position = [narrowest](const Map& map) { return std::log10(map.Width / narrowest); };
  for (const Map& map : maps)
  {
    chart.XTicks.emplace_back(position(map), Plain(100.0 * map.Width) + " %");
  }
  for (const Result& result : results)
  {
    AddLine(chart, NameOf(result), result.Widths, position, quantity.Of);
  }
  Plots::SetLogarithmicHeights(chart);
  return chart;
}

Plots::Chart ToleranceChart(const std::vector<Result>& results)
{
  Plots::Chart chart;
  chart.Title = "Memory of an isomap of all values";
  chart.XTitle = "Tolerance in voxels";
  chart.YTitle = "Bytes a pixel";
  for (const Result& result : results)
  {
    AddLine(
      chart, NameOf(result), result.Tolerances, [](const Map& map) { return map.Tolerance; },
      [](const Map& map) { return map.BytesAPixel; });
  }
  return chart;
}

}

void Write(const std::vector<Result>& results, const std::string& folder)
{
  const auto build = [](const Map& map) { return Measuring::Ratio(map.BuildMs, map.ColdMs); };
  const auto memory = [](const Map& map) { return map.BytesAPixel; };
  Plots::Write(
    WidthChart({ "Building an isomap", "Build time by that of a cold frame", build }, results),
    folder + "/isomap-build");
  Plots::Write(WidthChart({ "Memory of an isomap", "Bytes a pixel", memory }, results),
    folder + "/isomap-memory");
  Plots::Write(ToleranceChart(results), folder + "/isomap-tolerance");
}

}
