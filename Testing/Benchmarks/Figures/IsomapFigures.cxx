// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsomapFigures.h"

#include "FigurePictures.h"
#include "IsomapMaps.h"
#include "IsomapReport.h"
#include "Measuring.h"
#include "Plots.h"
#include "PngFile.h"
#include "Stage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

namespace IsomapFigures
{
namespace
{

using Figures::Settings;
using Figures::Subject;
using IsomapMaps::Map;
using IsomapReport::Result;

constexpr std::size_t NumberOfThresholds = 12;
constexpr double ThresholdStep = 0.02; ///< of the range of values
/// Of figure 9, in values of 8 bits, whose range the paper's thresholds are shares of.
constexpr std::array<double, 2> PaperThresholds = { 0.16, 0.22 };
constexpr double LargestByte = 255.0;
constexpr double Closeness = 1.4; ///< of figure 9, by which the volumes fill the pictures

/// How isomaps are made: as in the paper, or as by default here.
struct Technique
{
  std::string File;
  std::string Title;
  bool IsPaper = false;
};

const std::array<Technique, 2>& Techniques()
{
  static const std::array<Technique, 2> techniques = {
    Technique{
      "paper", "as in the paper (all values; there 35-40 s, then 40-75 s, then 1-1.5 s)", true },
    Technique{ "default", "as by default (bands, space leaping, exact)", false }
  };
  return techniques;
}

/// The picture without an isomap, building one, and the thresholds.
std::vector<double> ThresholdTimesOf(
  const Subject& subject, const Technique& technique, const Settings& settings)
{
  Stage stage(subject.Image, subject.Isovalue, settings.Size);
  Drawer drawer(stage);
  drawer.Mapper->SetSpaceLeaping(!technique.IsPaper);
  drawer.Draw(stage);
  std::vector<double> times = { drawer.DrawCold(stage) };
  if (technique.IsPaper)
  {
    drawer.Mapper->SetIsomapShadingToInterpolate();
    drawer.Mapper->SetIsomapRange(stage.IsovalueAt(0.0), stage.IsovalueAt(1.0));
    drawer.Mapper->SetIsomapMemoryLimit(IsomapMaps::LargeMemoryLimit);
    times.push_back(
      Measuring::TimeOf([&] { drawer.Mapper->BuildIsomap(stage.Renderer, stage.Volume); }));
  }
  // By default the first threshold builds a band.
  for (int i = 1; times.size() < NumberOfThresholds + 2; ++i)
  {
    stage.SetIsovalue(subject.Isovalue + stage.ShareOfRange(i * ThresholdStep));
    times.push_back(drawer.Draw(stage));
  }
  return times;
}

Plots::Chart ThresholdTimesChart(const Technique& technique)
{
  Plots::Chart chart;
  chart.Title = "Figure 7: isomap, " + technique.Title;
  chart.XTitle = "A picture without an isomap, building it, and one threshold after the other";
  chart.YTitle = "Milliseconds";
  chart.XTicks = { { 0, "without" }, { 1, "building" } };
  for (std::size_t i = 1; i <= NumberOfThresholds; ++i)
  {
    const auto number = static_cast<double>(i);
    chart.XTicks.emplace_back(number + 1.0, Plain(number));
  }
  return chart;
}

/// Ticks at 1, 2 and 5 times powers of ten, at their logarithms, from below the smallest to above
/// the largest value.
Plots::Ticks LogarithmicTicks(double smallest, double largest)
{
  Plots::Ticks ticks;
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
  series.Color = static_cast<int>(chart.Series.size());
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

/// Heights become logarithms.
void SetLogarithmicHeights(Plots::Chart& chart)
{
  std::vector<double> heights;
  for (Plots::Series& series : chart.Series)
  {
    heights.insert(heights.end(), series.Y.begin(), series.Y.end());
    std::transform(
      series.Y.begin(), series.Y.end(), series.Y.begin(), [](double y) { return std::log10(y); });
  }
  const auto [smallest, largest] = std::minmax_element(heights.begin(), heights.end());
  chart.YTicks = LogarithmicTicks(*smallest, *largest);
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
    AddLine(chart, result.Volume.Name, result.Widths, position, quantity.Of);
  }
  SetLogarithmicHeights(chart);
  return chart;
}

/// Measure maps of all subjects, and add them to the report.
std::vector<Result> MeasureMaps(const Settings& settings, std::vector<Map> Result::*maps,
  std::vector<Map> (*measure)(Stage&), const std::string& name, JsonWriter& json)
{
  std::vector<Result> results;
  json.OpenList(name);
  for (const Subject& subject : settings.Subjects)
  {
    Stage stage(subject.Image, subject.Isovalue, settings.Size);
    Result result;
    result.Volume = { subject.Name, subject.Isovalue };
    result.*maps = measure(stage);
    json.OpenObject();
    json.Add("volume", subject.Name);
    IsomapReport::AddTo(json, "maps", result.*maps);
    json.Close();
    results.push_back(result);
  }
  json.Close();
  return results;
}

}

void ThresholdTimes(const Settings& settings, JsonWriter& json)
{
  std::cout << "Figure 7: ms of a picture; thresholds in steps of " << Plain(100.0 * ThresholdStep)
            << " % of the range of values\n\n";
  const MarkdownTable table(
    { "isomap", "volume", "no isomap", "isomap", "median threshold", "slowest threshold" });
  json.OpenList("figure7");
  for (const Technique& technique : Techniques())
  {
    Plots::Chart chart = ThresholdTimesChart(technique);
    for (const Subject& subject : settings.Subjects)
    {
      const std::vector<double> times = ThresholdTimesOf(subject, technique, settings);
      std::vector<double> pictures(times.size());
      std::iota(pictures.begin(), pictures.end(), 0.0);
      chart.Series.push_back(
        { subject.Name, pictures, times, static_cast<int>(chart.Series.size()) });
      const std::vector<double> thresholds(times.begin() + 2, times.end());
      table.Row({ technique.File, subject.Name, Fixed(times[0], 1), Fixed(times[1], 1),
        Fixed(Measuring::Median(thresholds), 1), Fixed(Measuring::Worst(thresholds), 1) });
      json.OpenObject();
      json.Add("technique", technique.File);
      json.Add("volume", subject.Name);
      json.Add("frameMs", times);
      json.Close();
    }
    SetLogarithmicHeights(chart);
    Plots::Write(chart, settings.Output + "/figure7-" + technique.File);
  }
  json.Close();
  std::cout << '\n';
}

void TwoThresholds(const Settings& settings, JsonWriter& json)
{
  std::cout << "Figure 9: two thresholds from one isomap\n\n";
  const MarkdownTable table({ "volume", "threshold", "isovalue", "route", "ms" });
  json.OpenList("figure9");
  // Rows are to be of one length.
  const std::size_t picturesInRow = settings.Subjects.size() % 2 == 0 ? 4 : 2;
  std::vector<std::vector<vtkSmartPointer<vtkImageData>>> rows;
  for (const Subject& subject : settings.Subjects)
  {
    Stage stage(subject.Image, subject.Isovalue, settings.Size);
    stage.Approach(Closeness);
    Drawer drawer(stage);
    drawer.Mapper->SetIsomapRange(stage.IsovalueAt(0.0), stage.IsovalueAt(1.0));
    drawer.Mapper->SetIsomapMemoryLimit(IsomapMaps::LargeMemoryLimit);
    drawer.Draw(stage);
    drawer.Mapper->BuildIsomap(stage.Renderer, stage.Volume);
    if (rows.empty() || rows.back().size() == picturesInRow)
    {
      rows.emplace_back();
    }
    for (const double threshold : PaperThresholds)
    {
      stage.SetIsovalue(LargestByte * threshold);
      const double time = drawer.Draw(stage);
      rows.back().push_back(
        FigurePictures::WithCaption(drawer.Color, subject.Name + ": " + Plain(threshold)));
      table.Row({ subject.Name, Plain(threshold), Plain(stage.Isovalue()), drawer.Route(),
        Fixed(time, 1) });
      json.OpenObject();
      json.Add("volume", subject.Name);
      json.Add("threshold", threshold);
      json.Add("route", drawer.Route());
      json.Add("frameMs", time);
      json.Close();
    }
  }
  json.Close();
  std::cout << '\n';
  WritePng(FigurePictures::Tile(rows), settings.Output + "/figure9.png");
}

void CostOfWidth(const Settings& settings, JsonWriter& json)
{
  const std::vector<Result> results =
    MeasureMaps(settings, &Result::Widths, IsomapMaps::MeasureWidths, "isomapWidths", json);
  IsomapReport::PrintWidths(results);
  const auto build = [](const Map& map) { return Measuring::Ratio(map.BuildMs, map.ColdMs); };
  const auto memory = [](const Map& map) { return map.BytesAPixel; };
  Plots::Write(
    WidthChart({ "Building an isomap", "Build time by that of a cold frame", build }, results),
    settings.Output + "/isomap-build");
  Plots::Write(WidthChart({ "Memory of an isomap", "Bytes a pixel", memory }, results),
    settings.Output + "/isomap-memory");
}

void CostOfTolerance(const Settings& settings, JsonWriter& json)
{
  const std::vector<Result> results = MeasureMaps(
    settings, &Result::Tolerances, IsomapMaps::MeasureTolerances, "isomapTolerances", json);
  IsomapReport::PrintTolerances(results);
  Plots::Chart chart;
  chart.Title = "Memory of an isomap of all values";
  chart.XTitle = "Tolerance in voxels";
  chart.YTitle = "Bytes a pixel";
  for (const Result& result : results)
  {
    AddLine(
      chart, result.Volume.Name, result.Tolerances, [](const Map& map) { return map.Tolerance; },
      [](const Map& map) { return map.BytesAPixel; });
  }
  Plots::Write(chart, settings.Output + "/isomap-tolerance");
}

}
