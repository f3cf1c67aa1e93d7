// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"

#include "Drift.h"
#include "FigurePictures.h"
#include "Measuring.h"
#include "Plots.h"
#include "PngFile.h"
#include "Stage.h"

#include <vtkColorTransferFunction.h>
#include <vtkImageInterpolator.h>
#include <vtkImageResize.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <utility>

namespace Figures
{
namespace
{

constexpr double Degrees = 2.0; ///< of the orbit, a frame
constexpr double DegreesToNextPicture = 8.0;
constexpr double Closeness = 1.4; ///< of figure 8, by which the volumes fill the pictures
constexpr int KeyInterval = 7;
constexpr int KeyFrames = 28;

/// How frames are made: as in the paper, or as by default here.
struct Technique
{
  std::string File;
  std::string Title;
  bool IsPaper = false;

  void Set(vtkTemporalCoherenceVolumeMapper* mapper) const
  {
    mapper->RefineWhenStillOff();
    mapper->SetSpaceLeaping(!this->IsPaper);
    mapper->SetReuseAccuracy(this->IsPaper ? vtkTemporalCoherenceVolumeMapper::PAPER
                                           : vtkTemporalCoherenceVolumeMapper::BOUNDED);
  }
};

const std::array<Technique, 2>& Techniques()
{
  static const std::array<Technique, 2> techniques = {
    Technique{ "paper", "as in the paper (PAPER, plain ray caster)", true },
    Technique{ "bounded", "as by default (BOUNDED, space leaping)", false }
  };
  return techniques;
}

/// Twice the samples along each axis, interpolated linearly: 2 n - 1, so that the old ones stay.
vtkSmartPointer<vtkImageData> Doubled(vtkImageData* image)
{
  int size[3];
  image->GetDimensions(size);
  vtkNew<vtkImageInterpolator> linear;
  linear->SetInterpolationModeToLinear();
  vtkNew<vtkImageResize> resize;
  resize->SetInputData(image);
  resize->SetInterpolator(linear);
  resize->SetOutputDimensions(2 * size[0] - 1, 2 * size[1] - 1, 2 * size[2] - 1);
  resize->Update();
  return resize->GetOutput();
}

std::string SizeOf(vtkImageData* image)
{
  int size[3];
  image->GetDimensions(size);
  return Plain(size[0]) + "x" + Plain(size[1]) + "x" + Plain(size[2]);
}

/// Mean times of a frame, cold and cached, drawn in turn.
std::pair<double, double> AverageTimesOf(
  const Subject& subject, const Technique& technique, const Settings& settings)
{
  Stage stage(subject.Image, subject.Isovalue, settings.Size);
  Drawer cold(stage), cached(stage);
  technique.Set(cold.Mapper);
  technique.Set(cached.Mapper);
  cold.Mapper->ImageCacheOff();
  cold.Draw(stage);
  cached.Draw(stage);
  std::vector<double> coldTimes, cachedTimes;
  for (int frame = 0; frame < settings.Frames; ++frame)
  {
    stage.Orbit(Degrees);
    coldTimes.push_back(cold.Draw(stage));
    cachedTimes.push_back(cached.Draw(stage));
  }
  return { Measuring::Mean(coldTimes), Measuring::Mean(cachedTimes) };
}

Plots::Chart AverageTimesChart(const Settings& settings, const Technique& technique)
{
  Plots::Chart chart;
  chart.Title = "Figure 5: average time of a frame, " + technique.Title;
  chart.XTitle = "Volume";
  chart.YTitle = "Milliseconds a frame";
  chart.IsBars = true;
  chart.Series = { { "without image cache", {}, {}, 0 }, { "latest image as cache", {}, {}, 1 } };
  for (std::size_t i = 0; i < settings.Subjects.size(); ++i)
  {
    const Subject& subject = settings.Subjects[i];
    chart.XTicks.emplace_back(static_cast<double>(i), subject.Name);
  }
  return chart;
}

/// Times of frame after frame with key images. A first round, which builds the structures that
/// every frame uses, is not among them.
std::vector<double> KeyImageTimesOf(
  const Subject& subject, const Technique& technique, const Settings& settings)
{
  Stage stage(subject.Image, subject.Isovalue, settings.Size);
  Drawer drawer(stage);
  technique.Set(drawer.Mapper);
  drawer.Mapper->SetImageCachePolicyToKeyImage();
  drawer.Mapper->SetKeyImageInterval(KeyInterval);
  std::vector<double> times;
  for (int frame = -KeyInterval; frame < KeyFrames; ++frame)
  {
    const double time = drawer.Draw(stage);
    if (frame >= 0)
    {
      times.push_back(time);
    }
    stage.Orbit(Degrees);
  }
  return times;
}

std::vector<double> Counted(std::size_t n)
{
  std::vector<double> numbers(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    numbers[i] = static_cast<double>(i);
  }
  return numbers;
}

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

/// A colour for each speed, solid for PAPER and dashed for BOUNDED.
Plots::Series LogarithmOf(const Drift::Course& course, int color, double none)
{
  Plots::Series series;
  series.Name = course.Accuracy + ", " + Fixed(course.Degrees, 1) + " degrees";
  series.Color = color;
  series.IsDashed = course.Accuracy == "BOUNDED";
  for (std::size_t i = 0; i < course.Frames.size(); ++i)
  {
    const double different = course.Different[i];
    series.X.push_back(course.Frames[i]);
    series.Y.push_back(different > 0.0 ? std::max(none, std::log10(different)) : none);
  }
  return series;
}

}

std::vector<Subject> LoadSubjects()
{
  std::vector<Subject> subjects;
  const auto add = [&subjects](const std::string& name, vtkImageData* image, double isovalue) {
    subjects.push_back({ name + " " + SizeOf(image), image, isovalue });
  };
  if (const vtkSmartPointer<vtkImageData> brain = LoadOrTell("brain.vti"))
  {
    add("brain", brain, 40);
    add("brain doubled", Doubled(brain), 40);
  }
  if (const vtkSmartPointer<vtkImageData> engine = LoadOrTell("engine.vti"))
  {
    add("engine", engine, 70);
  }
  add("four spheres", Volumes::FourSpheres(256), 100);
  return subjects;
}

void AverageTimes(const Settings& settings, JsonWriter& json)
{
  std::cout << "Figure 5: average ms of a frame, " << Degrees << " degrees a frame\n\n";
  const MarkdownTable table({ "frames", "volume", "without cache", "latest image", "ratio" });
  json.OpenList("figure5");
  for (const Technique& technique : Techniques())
  {
    Plots::Chart chart = AverageTimesChart(settings, technique);
    for (std::size_t i = 0; i < settings.Subjects.size(); ++i)
    {
      const Subject& subject = settings.Subjects[i];
      const auto [cold, cached] = AverageTimesOf(subject, technique, settings);
      chart.Series[0].X.push_back(static_cast<double>(i));
      chart.Series[0].Y.push_back(cold);
      chart.Series[1].X.push_back(static_cast<double>(i));
      chart.Series[1].Y.push_back(cached);
      table.Row({ technique.File, subject.Name, Fixed(cold, 1), Fixed(cached, 1),
        Fixed(Measuring::Ratio(cold, cached), 2) });
      json.OpenObject();
      json.Add("technique", technique.File);
      json.Add("volume", subject.Name);
      json.Add("coldMs", cold);
      json.Add("cachedMs", cached);
      json.Close();
    }
    Plots::Write(chart, settings.Output + "/figure5-" + technique.File);
  }
  json.Close();
  std::cout << '\n';
}

void KeyImageTimes(const Settings& settings, JsonWriter& json)
{
  std::cout << "Figure 6: ms of a frame, key images every " << KeyInterval << " frames\n\n";
  const MarkdownTable table({ "frames", "volume", "median", "slowest" });
  json.OpenList("figure6");
  for (const Technique& technique : Techniques())
  {
    Plots::Chart chart;
    chart.Title = "Figure 6: a key image every 7 frames, " + technique.Title;
    chart.XTitle = "Frame";
    chart.YTitle = "Milliseconds";
    for (const Subject& subject : settings.Subjects)
    {
      const std::vector<double> times = KeyImageTimesOf(subject, technique, settings);
      chart.Series.push_back(
        { subject.Name, Counted(times.size()), times, static_cast<int>(chart.Series.size()) });
      table.Row({ technique.File, subject.Name, Fixed(Measuring::Median(times), 1),
        Fixed(Measuring::Worst(times), 1) });
      json.OpenObject();
      json.Add("technique", technique.File);
      json.Add("volume", subject.Name);
      json.Add("frameMs", times);
      json.Close();
    }
    Plots::Write(chart, settings.Output + "/figure6-" + technique.File);
  }
  json.Close();
  std::cout << '\n';
}

void AnswersInColor(const Settings& settings, JsonWriter& json)
{
  std::cout << "Figure 8: the next picture, " << DegreesToNextPicture << " degrees on\n\n";
  const MarkdownTable table({ "volume", "rays not served by the cache" });
  json.OpenList("figure8");
  std::vector<vtkSmartPointer<vtkImageData>> caches, next;
  for (const Subject& subject : settings.Subjects)
  {
    Stage stage(subject.Image, subject.Isovalue, settings.Size);
    // Blue, which yellow stands out from.
    vtkNew<vtkColorTransferFunction> blue;
    blue->AddRGBPoint(subject.Isovalue, 0.55, 0.68, 0.88);
    stage.Volume->GetProperty()->SetColor(blue);
    Drawer drawer(stage);
    Techniques()[0].Set(drawer.Mapper);
    drawer.Mapper->ColorByAnswerOn();
    stage.Approach(Closeness);
    drawer.Draw(stage);
    caches.push_back(FigurePictures::WithCaption(drawer.Color, subject.Name));
    stage.Orbit(DegreesToNextPicture);
    drawer.Draw(stage);
    const double traced = 100.0 *
      Measuring::Ratio(static_cast<double>(drawer.Mapper->GetNumberOfPossibleHits()),
        static_cast<double>(drawer.Mapper->GetNumberOfRays()));
    const std::string share = Fixed(traced, 1) + " %";
    next.push_back(FigurePictures::WithCaption(
      drawer.Color, Plain(DegreesToNextPicture) + " degrees on, " + share + " traced"));
    table.Row({ subject.Name, share });
    json.OpenObject();
    json.Add("volume", subject.Name);
    json.Add("possibleHitsPercent", traced);
    json.Close();
  }
  json.Close();
  std::cout << '\n';
  WritePng(FigurePictures::Tile({ caches, next }), settings.Output + "/figure8.png");
}

void DriftOverTime(const Settings& settings, JsonWriter& json)
{
  // The engine, or what there is.
  const auto engine = std::find_if(settings.Subjects.begin(), settings.Subjects.end(),
    [](const Subject& subject) { return subject.Name.rfind("engine", 0) == 0; });
  const Subject& subject = engine == settings.Subjects.end() ? settings.Subjects.back() : *engine;
  Stage stage(subject.Image, subject.Isovalue, settings.Size);
  const std::vector<Drift::Course> courses = Drift::Run(stage, settings.DriftFrames);
  std::cout << "Drift: percent of the pixels that differ from cold, " << subject.Name << "\n\n";
  Drift::PrintTable(courses);
  std::cout << '\n';
  Drift::AddTo(json, courses);

  Plots::Chart chart;
  chart.Title = "Drift of pictures each made from the last: " + subject.Name;
  chart.XTitle = "Frame";
  chart.YTitle = "Pixels that differ from the cold picture";
  double worst = 0.0;
  for (const Drift::Course& course : courses)
  {
    worst = std::max(worst, Measuring::Worst(course.Different));
  }
  chart.YTicks = DecadeTicks(worst, settings.Size);
  for (const Drift::Course& course : courses)
  {
    const int color = static_cast<int>(chart.Series.size() / 2);
    chart.Series.push_back(LogarithmOf(course, color, chart.YTicks.front().first));
  }
  Plots::Write(chart, settings.Output + "/drift");
}

}
