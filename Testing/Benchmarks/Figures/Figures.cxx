// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"

#include "FigurePictures.h"
#include "Measuring.h"
#include "PaperNumbers.h"
#include "Plots.h"
#include "PngFile.h"
#include "Stage.h"

#include <vtkColorTransferFunction.h>
#include <vtkImageInterpolator.h>
#include <vtkImageResize.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <array>
#include <iostream>

namespace Figures
{
namespace
{

constexpr double Degrees = 2.0; ///< of the orbit, a frame
constexpr double DegreesToNextPicture = 8.0;
constexpr int SmallSize = 64; ///< samples a side of the only volume of a quick look
constexpr int KeyInterval = 7;
constexpr int KeyFrames = 28;

/// How frames are made: as in the paper, or as by default here.
struct Technique
{
  std::string File;
  std::string Title;
  std::string Short;
  bool IsPaper = false;

  void Set(vtkTemporalCoherenceVolumeMapper* mapper) const
  {
    mapper->RefineWhenStillOff();
    mapper->SetSpaceLeaping(!this->IsPaper);
    mapper->SetReuseAccuracy(this->IsPaper ? vtkTemporalCoherenceVolumeMapper::PAPER
                                           : vtkTemporalCoherenceVolumeMapper::EXACT);
  }
};

const std::array<Technique, 2>& Techniques()
{
  static const std::array<Technique, 2> techniques = {
    Technique{ "paper", "as in the paper (PAPER, plain ray caster)", "as in the paper", true },
    Technique{ "default", "as by default (EXACT, space leaping)", "by default", false }
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

/// Mean milliseconds of a frame.
struct Average
{
  double Cold = 0.0;
  double Cached = 0.0;

  double SpeedUp() const { return Measuring::Ratio(this->Cold, this->Cached); }
};

/// Cold and cached, drawn in turn.
Average AverageTimesOf(const Subject& subject, const Technique& technique, const Settings& settings)
{
  Stage stage(subject.Image, subject.Isovalue, settings.Size);
  Drawer cold(stage), cached(stage);
  technique.Set(cold.Mapper);
  technique.Set(cached.Mapper);
  cold.Mapper->ReuseFramesOff();
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

void AddBar(Plots::Series& bars, std::size_t subject, double height)
{
  bars.X.push_back(static_cast<double>(subject));
  bars.Y.push_back(height);
}

/// Bars for each subject.
Plots::Chart BarChart(
  const Settings& settings, const std::string& title, const std::string& heights)
{
  Plots::Chart chart;
  chart.Title = title;
  chart.XTitle = "Volume";
  chart.YTitle = heights;
  chart.IsBars = true;
  for (std::size_t i = 0; i < settings.Subjects.size(); ++i)
  {
    chart.XTicks.emplace_back(static_cast<double>(i), settings.Subjects[i].Name);
  }
  return chart;
}

Plots::Chart AverageTimesChart(
  const Settings& settings, const Technique& technique, const std::vector<Average>& averages)
{
  Plots::Chart chart = BarChart(
    settings, "Figure 5: average time of a frame, " + technique.Title, "Milliseconds a frame");
  chart.Series = { { "without image cache", {}, {}, 0 }, { "latest image as cache", {}, {}, 1 } };
  for (std::size_t i = 0; i < averages.size(); ++i)
  {
    AddBar(chart.Series[0], i, averages[i].Cold);
    AddBar(chart.Series[1], i, averages[i].Cached);
  }
  return chart;
}

/// What the paper says of a subject; null if it has no numbers of it.
const PaperNumbers::CachedPicture* PaperOf(const Subject& subject)
{
  const auto& all = PaperNumbers::CachedPictures;
  const auto* found = std::find_if(all.begin(), all.end(),
    [&subject](const auto& picture) { return subject.Name.rfind(picture.Volume, 0) == 0; });
  return found == all.end() ? nullptr : found;
}

/// Times without the cache by those with it: the paper's and those of each technique.
Plots::Chart SpeedUpChart(const Settings& settings, const std::vector<std::vector<Average>>& all)
{
  Plots::Chart chart = BarChart(settings, "Figure 5: what the latest image as cache gains",
    "Time without image cache by time with it");
  for (std::size_t technique = 0; technique < all.size(); ++technique)
  {
    Plots::Series bars;
    bars.Name = Techniques()[technique].Title;
    bars.Color = static_cast<int>(technique);
    for (std::size_t i = 0; i < all[technique].size(); ++i)
    {
      AddBar(bars, i, all[technique][i].SpeedUp());
    }
    chart.Series.push_back(bars);
  }
  Plots::Series paper;
  paper.Name = "the paper (50 to 15 s, 75 to 20 s)";
  paper.Color = static_cast<int>(all.size());
  for (std::size_t i = 0; i < settings.Subjects.size(); ++i)
  {
    const PaperNumbers::CachedPicture* picture = PaperOf(settings.Subjects[i]);
    AddBar(paper, i, picture ? picture->WithoutCache / picture->WithCache : 0.0);
  }
  chart.Series.push_back(paper);
  return chart;
}

void PrintAverages(const Settings& settings, const std::vector<std::vector<Average>>& all)
{
  const PagePart part("figure5");
  std::cout << Plain(Degrees) << " degrees a frame, means of " << settings.Frames << " frames, "
            << settings.Size << " x " << settings.Size << " pixels.\n\n";
  std::vector<std::string> head = { "volume", "paper: without cache", "latest image", "gain" };
  for (const Technique& technique : Techniques())
  {
    const std::vector<std::string> columns = { technique.Short + ": without cache", "latest image",
      "gain" };
    head.insert(head.end(), columns.begin(), columns.end());
  }
  const MarkdownTable table(head);
  for (std::size_t i = 0; i < settings.Subjects.size(); ++i)
  {
    std::vector<std::string> cells = { settings.Subjects[i].Name, "-", "-",
      PaperNumbers::UsualSpeedUp };
    if (const PaperNumbers::CachedPicture* picture = PaperOf(settings.Subjects[i]))
    {
      cells = { settings.Subjects[i].Name, Plain(picture->WithoutCache) + " s",
        Plain(picture->WithCache) + " s", Fixed(picture->WithoutCache / picture->WithCache, 1) };
    }
    for (const std::vector<Average>& averages : all)
    {
      cells.push_back(Fixed(averages[i].Cold, 1) + " ms");
      cells.push_back(Fixed(averages[i].Cached, 1) + " ms");
      cells.push_back(Fixed(averages[i].SpeedUp(), 1));
    }
    table.Row(cells);
  }
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

}

void SetUp(Stage& stage, const Subject& subject, const Style::Color& color)
{
  Style::AddLights(stage.Renderer);
  Style::Show(stage.Volume->GetProperty(), { { subject.Isovalue, color } });
  Style::PointCamera(stage.Renderer, stage.Image->GetBounds(), subject.View);
}

std::vector<Subject> LoadSubjects(bool onlySmall)
{
  const Style::View brainView = { { -1.0, -0.6, 0.9 }, { 0.0, -1.0, 0.0 }, 1.7 };
  const Style::View engineView = { { 1.0, -1.4, 0.9 }, { 0.0, 0.0, 1.0 }, 1.6 };
  std::vector<Subject> subjects;
  const auto add = [&subjects](const std::string& name, vtkImageData* image, double isovalue,
                     const Style::View& view) {
    subjects.push_back({ name + " " + SizeOf(image), image, isovalue, view, true });
  };
  if (onlySmall)
  {
    add("four spheres", Volumes::FourSpheres(SmallSize), 100, {});
    return subjects;
  }
  if (const vtkSmartPointer<vtkImageData> brain = LoadOrTell("brain.vti"))
  {
    add("brain", brain, 40, brainView);
    add("brain doubled", Doubled(brain), 40, brainView);
    subjects.back().IsPictured = false;
  }
  if (const vtkSmartPointer<vtkImageData> engine = LoadOrTell("engine.vti"))
  {
    add("engine", engine, 70, engineView);
  }
  add("four spheres", Volumes::FourSpheres(256), 100, {});
  return subjects;
}

void AverageTimes(const Settings& settings, JsonWriter& json)
{
  std::vector<std::vector<Average>> all;
  json.OpenList("figure5");
  for (const Technique& technique : Techniques())
  {
    all.emplace_back();
    for (const Subject& subject : settings.Subjects)
    {
      const Average average = AverageTimesOf(subject, technique, settings);
      all.back().push_back(average);
      json.OpenObject();
      json.Add("technique", technique.File);
      json.Add("volume", subject.Name);
      json.Add("coldMs", average.Cold);
      json.Add("cachedMs", average.Cached);
      json.Close();
    }
    Plots::Write(AverageTimesChart(settings, technique, all.back()),
      settings.Output + "/figure5-" + technique.File);
  }
  json.Close();
  PrintAverages(settings, all);
  Plots::Write(SpeedUpChart(settings, all), settings.Output + "/figure5");
}

void KeyImageTimes(const Settings& settings, JsonWriter& json)
{
  const PagePart part("figure6");
  std::cout << "A key image every " << KeyInterval << " frames, " << Plain(Degrees)
            << " degrees a frame; ms of a frame.\n\n";
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
      table.Row({ technique.Short, subject.Name, Fixed(Measuring::Median(times), 1),
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
}

void AnswersInColor(const Settings& settings, JsonWriter& json)
{
  const PagePart part("figure8");
  const MarkdownTable table({ "volume", "rays not served by the cache" });
  json.OpenList("figure8");
  std::vector<vtkSmartPointer<vtkImageData>> caches, next;
  for (const Subject& subject : settings.Subjects)
  {
    Stage stage(subject.Image, subject.Isovalue, settings.Size);
    SetUp(stage, subject, Style::Steel); // which yellow stands out from
    Drawer drawer(stage);
    Techniques()[0].Set(drawer.Mapper);
    drawer.Mapper->ColorByAnswerOn();
    drawer.Draw(stage);
    const auto cache = FigurePictures::WithCaption(drawer.Color, subject.Name);
    stage.Orbit(DegreesToNextPicture);
    drawer.Draw(stage);
    const double traced = 100.0 *
      Measuring::Ratio(
        static_cast<double>(drawer.Mapper->GetStatistics()->GetNumberOfPossibleHits()),
        static_cast<double>(drawer.Mapper->GetStatistics()->GetNumberOfRays()));
    const std::string share = Fixed(traced, 1) + " %";
    if (subject.IsPictured)
    {
      caches.push_back(cache);
      next.push_back(FigurePictures::WithCaption(
        drawer.Color, Plain(DegreesToNextPicture) + " degrees on, " + share + " not served"));
    }
    table.Row({ subject.Name, share });
    json.OpenObject();
    json.Add("volume", subject.Name);
    json.Add("possibleHitsPercent", traced);
    json.Close();
  }
  json.Close();
  WritePng(FigurePictures::Tile({ caches, next }), settings.Output + "/figure8.png");
}

}
