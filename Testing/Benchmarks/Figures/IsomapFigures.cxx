// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsomapFigures.h"

#include "FigurePictures.h"
#include "IsomapMaps.h"
#include "Measuring.h"
#include "PaperNumbers.h"
#include "Plots.h"
#include "PngFile.h"
#include "Stage.h"

#include <array>
#include <cstddef>
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

constexpr std::size_t NumberOfThresholds = 12;
constexpr double ThresholdStep = 0.02; ///< of the range of values
/// Of figure 9, in values of 8 bits, whose range the paper's thresholds are shares of.
constexpr std::array<double, 2> PaperThresholds = { 0.16, 0.22 };
constexpr int PaperColor = 2;
/// Of which figure 7 shows times beside the paper's: the brain in both of its sizes.
constexpr std::size_t SubjectsBeside = 2;
constexpr double LargestByte = 255.0;

/// How isomaps are made: as in the paper, or as by default here.
struct Technique
{
  std::string File;
  std::string Title;
  std::string Short;
  bool IsPaper = false;
};

const std::array<Technique, 2>& Techniques()
{
  static const std::array<Technique, 2> techniques = {
    Technique{ "paper", "as in the paper (all values, plain ray caster)", "as in the paper", true },
    Technique{ "default", "as by default (bands, space leaping, exact)", "by default", false }
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

Plots::Chart ThresholdTimesChart(const std::string& title, const std::string& unit)
{
  Plots::Chart chart;
  chart.Title = "Figure 7: isomap, " + title;
  chart.XTitle = "A picture without an isomap, building it, and one threshold after the other";
  chart.YTitle = unit;
  chart.XTicks = { { 0, "without" }, { 1, "building" } };
  for (std::size_t i = 1; i <= NumberOfThresholds; ++i)
  {
    const auto number = static_cast<double>(i);
    chart.XTicks.emplace_back(number + 1.0, Plain(number));
  }
  return chart;
}

/// Where the pictures stand in such charts.
std::vector<double> Pictures()
{
  std::vector<double> pictures(NumberOfThresholds + 2);
  std::iota(pictures.begin(), pictures.end(), 0.0);
  return pictures;
}

/// Lines through the shortest and the longest times that the paper tells.
void AddPaper(Plots::Chart& chart)
{
  using namespace PaperNumbers;
  const auto add = [&chart](const std::string& name, double Seconds::*end)
  {
    std::vector<double> seconds(NumberOfThresholds + 2, Threshold.*end);
    seconds[0] = WithoutIsomap.*end;
    seconds[1] = BuildingIsomap.*end;
    chart.Series.push_back({ name, Pictures(), seconds, PaperColor, end == &Seconds::To });
  };
  add("the paper, at least", &Seconds::From);
  add("the paper, at most", &Seconds::To);
}

/// A line of one technique, in seconds.
void AddBeside(Plots::Chart& chart, const Technique& technique, const Plots::Series& milliseconds)
{
  Plots::Series line = milliseconds;
  line.Name = technique.Short + ", " + milliseconds.Name;
  line.Color = technique.IsPaper ? 0 : 1;
  line.IsDashed = milliseconds.Color % 2 != 0;
  for (double& y : line.Y)
  {
    y *= 1e-3;
  }
  chart.Series.push_back(line);
}

void PrintPaper(const MarkdownTable& table)
{
  using namespace PaperNumbers;
  const auto text = [](const Seconds& seconds)
  { return Plain(seconds.From) + "-" + Plain(seconds.To) + " s"; };
  table.Row({ "the paper", "all", text(WithoutIsomap), text(BuildingIsomap), "1-2", text(Threshold),
    "-", "30" });
}

/// Times of ThresholdTimesOf.
void PrintThresholds(const MarkdownTable& table, const std::string& technique,
  const std::string& volume, const std::vector<double>& times)
{
  const std::vector<double> thresholds(times.begin() + 2, times.end());
  const double median = Measuring::Median(thresholds);
  table.Row({ technique, volume, Fixed(times[0], 1) + " ms", Fixed(times[1], 1) + " ms",
    Fixed(Measuring::Ratio(times[1], times[0]), 1), Fixed(median, 1) + " ms",
    Fixed(Measuring::Worst(thresholds), 1) + " ms", Fixed(Measuring::Ratio(times[0], median), 1) });
}

/// Median of drawing one threshold after the other; the first is seen in the end.
double TimeOfThreshold(Stage& stage, Drawer& drawer, double threshold, double other)
{
  constexpr int draws = 5;
  std::vector<double> times;
  while (times.size() < draws)
  {
    stage.SetIsovalue(LargestByte * other);
    drawer.Draw(stage);
    stage.SetIsovalue(LargestByte * threshold);
    times.push_back(drawer.Draw(stage));
  }
  return Measuring::Median(times);
}

}

void ThresholdTimes(const Settings& settings, JsonWriter& json)
{
  const PagePart part("figure7");
  std::cout << "Thresholds in steps of " << Plain(100.0 * ThresholdStep)
            << " % of the range of values.\n\n";
  const MarkdownTable table({ "isomap", "volume", "no isomap", "isomap built", "/ no isomap",
    "median threshold", "slowest threshold", "no isomap / threshold" });
  PrintPaper(table);
  json.OpenList("figure7");
  Plots::Chart beside = ThresholdTimesChart("the paper's seconds and ours", "Seconds");
  AddPaper(beside);
  for (const Technique& technique : Techniques())
  {
    Plots::Chart chart = ThresholdTimesChart(technique.Title, "Milliseconds");
    for (const Subject& subject : settings.Subjects)
    {
      const std::vector<double> times = ThresholdTimesOf(subject, technique, settings);
      chart.Series.push_back(
        { subject.Name, Pictures(), times, static_cast<int>(chart.Series.size()) });
      if (chart.Series.size() <= SubjectsBeside)
      {
        AddBeside(beside, technique, chart.Series.back());
      }
      PrintThresholds(table, technique.Short, subject.Name, times);
      json.OpenObject();
      json.Add("technique", technique.File);
      json.Add("volume", subject.Name);
      json.Add("frameMs", times);
      json.Close();
    }
    Plots::SetLogarithmicHeights(chart);
    Plots::Write(chart, settings.Output + "/figure7-" + technique.File);
  }
  json.Close();
  Plots::SetLogarithmicHeights(beside);
  Plots::Write(beside, settings.Output + "/figure7");
}

void TwoThresholds(const Settings& settings, JsonWriter& json)
{
  const PagePart part("figure9");
  const MarkdownTable table({ "volume", "threshold", "isovalue", "route", "ms" });
  json.OpenList("figure9");
  std::vector<std::vector<vtkSmartPointer<vtkImageData>>> rows(PaperThresholds.size());
  for (const Subject& subject : settings.Subjects)
  {
    Stage stage(subject.Image, subject.Isovalue, settings.Size);
    Figures::SetUp(stage, subject, Style::Skin);
    Drawer drawer(stage);
    drawer.Mapper->SetIsomapRange(stage.IsovalueAt(0.0), stage.IsovalueAt(1.0));
    drawer.Mapper->SetIsomapMemoryLimit(IsomapMaps::LargeMemoryLimit);
    drawer.Draw(stage);
    drawer.Mapper->BuildIsomap(stage.Renderer, stage.Volume);
    for (std::size_t i = 0; i < PaperThresholds.size(); ++i)
    {
      const double threshold = PaperThresholds[i];
      const double time =
        TimeOfThreshold(stage, drawer, threshold, PaperThresholds[PaperThresholds.size() - 1 - i]);
      if (subject.IsPictured)
      {
        rows[i].push_back(
          FigurePictures::WithCaption(drawer.Color, subject.Name + ": " + Plain(threshold)));
      }
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
  WritePng(FigurePictures::Tile(rows), settings.Output + "/figure9.png");
}

}
