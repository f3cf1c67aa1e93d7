// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RouteRows.h"

#include "AnswerPicture.h"
#include "Measuring.h"
#include "Stage.h"

#include <vtkColorTransferFunction.h>
#include <vtkVolumeProperty.h>

#include <functional>
#include <iostream>

namespace RouteRows
{
namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;

constexpr double Degrees = 4.0;      ///< of the orbit, a frame
constexpr double Step = 1.0 / 256.0; ///< of an isovalue, as a share of the range of values

/// A way to come to a frame.
struct Row
{
  std::string File;
  std::string Route;
  std::string Changed;
  /// Once, before the first frame.
  std::function<void(Stage&, Drawer&)> Begin;
  /// Before each frame that is timed.
  std::function<void(Stage&, Drawer&, int frame)> Change;
  bool HasAnswers = true; ///< of its own
};

/// Medians of the frames that the route has made.
struct Result
{
  double Ms = 0.0;
  double PercentUnknown = 0.0; ///< possible hits
  double PercentTraced = 0.0;
  double SamplesARay = 0.0;
  double PercentDifferent = 0.0; ///< of the last frame, from the cold picture
};

struct Scene
{
  Scene(const GallerySettings& settings, const Subject& subject)
    : Place(subject.Image, subject.Isovalues[0], settings.Size)
    , Shown(subject)
    , Frames(settings.Frames)
  {
    Style::AddLights(this->Place.Renderer);
  }

  /// Back to the first view, isovalue and colour.
  void Reset()
  {
    Style::Show(this->Place.Volume->GetProperty(), { { this->Shown.Isovalues[0], Style::Steel } });
    Style::PointCamera(this->Place.Renderer, this->Place.Image->GetBounds(), this->Shown.View);
  }

  Stage Place;
  const Subject& Shown;
  const int Frames;
};

/// Orbits end where the scene begins, so that all of them show one view.
Row Orbit(const std::string& file, const std::string& route, const std::string& changed, int frames,
  const std::function<void(Mapper*)>& set)
{
  return { file, route, changed,
    [=](Stage& stage, Drawer& drawer)
    {
      set(drawer.Mapper);
      stage.Orbit(-Degrees * frames);
    },
    [](Stage& stage, Drawer&, int) { stage.Orbit(Degrees); } };
}

std::vector<Row> Orbits(int frames)
{
  const std::string turned = "the camera, " + Plain(Degrees) + " degrees; ";
  return { Orbit("cold", "Cold", turned + "`ReuseFramesOff()`: nothing is known of the last frame",
             frames, [](Mapper* mapper) { mapper->ReuseFramesOff(); }),
    Orbit("exact", "Cold", turned + "`EXACT`, the default: the cold picture, to the last bit",
      frames, [](Mapper* mapper) { mapper->SetReuseAccuracyToExact(); }),
    Orbit("paper", "ImageCache", turned + "`PAPER`, as published", frames,
      [](Mapper* mapper) { mapper->SetReuseAccuracyToPaper(); }) };
}

std::vector<Row> Isovalues(const Scene& scene)
{
  const double first = scene.Shown.Isovalues[0], last = scene.Shown.Isovalues[1];
  const int frames = scene.Frames;
  const auto nothing = [](Stage&, Drawer&) {};
  const auto raiseAnew = [=](Stage& stage, Drawer& drawer, int)
  {
    drawer.Mapper->ClearCache();
    stage.SetIsovalue(first);
    drawer.Draw(stage);
    stage.SetIsovalue(first + stage.ShareOfRange(Step));
  };
  const auto creep = [=](Stage& stage, Drawer&, int frame)
  { stage.SetIsovalue(first + stage.SweepStep(frame)); };
  const auto buildRange = [=](Stage& stage, Drawer& drawer)
  {
    drawer.Draw(stage);
    drawer.Mapper->SetIsomapRange(first, last);
    drawer.Mapper->BuildIsomap(stage.Renderer, stage.Volume);
  };
  const auto sweep = [=](Stage& stage, Drawer&, int frame)
  { stage.SetIsovalue(first + (last - first) * (frame + 1) / frames); };
  return { { "build", "IsomapBuild",
             "the isovalue, for the first time in this view: some tiles are built, others traced",
             nothing, raiseAnew },
    { "lookup", "IsomapLookup", "the isovalue, in small steps: looked up in what was built",
      buildRange, creep },
    { "range", "IsomapLookup",
      "the isovalue, any from " + Plain(first) + " to " + Plain(last) + " (here " + Plain(last) +
        "); `SetIsomapRange()` and `BuildIsomap()` before",
      buildRange, sweep } };
}

std::vector<Row> Still()
{
  const auto nothing = [](Stage&, Drawer&) {};
  const auto recolor = [](Stage& stage, Drawer&, int frame)
  {
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, Style::Gold[0], Style::Gold[1], Style::Gold[2] + 0.001 * (frame % 10));
    stage.Volume->GetProperty()->SetColor(color);
  };
  return { { "reshade", "Reshade", "the colour", nothing, recolor, false },
    { "redisplay", "Redisplay", "nothing", nothing, [](Stage&, Drawer&, int) {}, false } };
}

/// Two surfaces, one within the other, that are seen through.
std::vector<Row> SeeThrough(const Scene& scene)
{
  const double outer = scene.Shown.Isovalues[0], inner = scene.Shown.Isovalues[1];
  const auto show = [=](Stage& stage, double opacity)
  {
    Style::Show(stage.Volume->GetProperty(),
      { { outer, Style::Steel, opacity }, { inner, Style::Gold, 0.5 } });
  };
  const auto begin = [=](Stage& stage, Drawer& drawer)
  {
    drawer.Mapper->IsomapOff();
    show(stage, 0.4);
  };
  const auto fade = [=](Stage& stage, Drawer&, int frame)
  { show(stage, 0.41 + 0.01 * (frame % 2)); };
  return { { "recomposite", "Recomposite", "the opacity of one of two see-through surfaces", begin,
    fade, false } };
}

Result Measure(Scene& scene, const Row& row, const GallerySettings& settings, std::string& picture)
{
  Stage& stage = scene.Place;
  scene.Reset();
  Drawer drawer(stage);
  drawer.Mapper->RefineWhenStillOff();
  row.Begin(stage, drawer);
  drawer.Draw(stage);
  std::vector<double> ms, unknown, traced, samples;
  for (int frame = 0; frame < scene.Frames; ++frame)
  {
    row.Change(stage, drawer, frame);
    const double time = drawer.Draw(stage);
    if (drawer.Route() == row.Route)
    {
      const auto rays = static_cast<double>(drawer.Mapper->GetStatistics()->GetNumberOfRays());
      ms.push_back(time);
      unknown.push_back(100.0 *
        static_cast<double>(drawer.Mapper->GetStatistics()->GetNumberOfPossibleHits()) / rays);
      traced.push_back(100.0 *
        static_cast<double>(drawer.Mapper->GetStatistics()->GetNumberOfTracedRays()) / rays);
      samples.push_back(
        static_cast<double>(drawer.Mapper->GetStatistics()->GetNumberOfFieldSamples()) / rays);
    }
  }
  if (ms.empty())
  {
    throw Measuring::Failure("No frame was made by the route " + row.Route + ", but by " +
      drawer.Route() + ": mend the row '" + row.File + "' of RouteRows.cxx.");
  }
  picture = Hang(WithAnswers(drawer, row.HasAnswers), "route-" + row.File, row.Route, settings);
  Drawer cold(stage);
  cold.Draw(stage);
  return { Measuring::Median(ms), Measuring::Median(unknown), Measuring::Median(traced),
    Measuring::Median(samples), PercentDifferent(drawer, cold, stage) };
}

}

void Make(GallerySettings& settings, JsonWriter& json)
{
  const Style::View view = { { 1.0, -1.4, 0.9 }, { 0.0, 0.0, 1.0 }, 1.4 };
  const Subject subject =
    FirstOf({ { "engine.vti", "CT engine 256x256x110", { 70.0, 180.0 }, view },
              { "ch2.nii.gz", "MR head 181x217x181", { 45.0, 85.0 },
                { { -0.5, 1.0, 0.15 }, { 0.0, 0.0, 1.0 }, 1.35 } },
              SpheresInstead({ 100.0, 180.0 }) },
      settings);
  Scene scene(settings, subject);
  std::vector<Row> rows = Orbits(scene.Frames);
  for (const std::vector<Row>& more : { Isovalues(scene), Still(), SeeThrough(scene) })
  {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  const PagePart part("routes");
  std::cout << subject.Name << ", isovalue " << Plain(subject.Isovalues[0]) << ", " << settings.Size
            << " x " << settings.Size << " pixels, `MakeImage`, medians of up to "
            << settings.Frames << " frames:\n\n";
  const MarkdownTable table(
    { "route, and what has changed", "picture; in yellow what was not known", "ms", "possible hits",
      "rays traced", "samples read a ray", "pixels not as cold" });
  json.OpenList("routes");
  for (const Row& row : rows)
  {
    std::string picture;
    const Result result = Measure(scene, row, settings, picture);
    table.Row({ "**" + row.Route + "**<br>" + row.Changed, picture, Fixed(result.Ms, 1),
      Fixed(result.PercentUnknown, 1) + " %", Fixed(result.PercentTraced, 1) + " %",
      Fixed(result.SamplesARay, 2), Fixed(result.PercentDifferent, 4) + " %" });
    json.OpenObject();
    json.Add("row", row.File);
    json.Add("route", row.Route);
    json.Add("frameMs", result.Ms);
    json.Add("possibleHitsPercent", result.PercentUnknown);
    json.Add("tracedPercent", result.PercentTraced);
    json.Add("samplesARay", result.SamplesARay);
    json.Add("differentPercent", result.PercentDifferent);
    json.Close();
  }
  json.Close();
}

}
