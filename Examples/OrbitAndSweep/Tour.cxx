// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Tour.h"

#include "Options.h"
#include "Pictures.h"
#include "Program/UserError.h"
#include "Scene.h"
#include "View/Isovalue.h"

#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkTimerLog.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <sstream>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace
{

constexpr double DegreesPerFrame = 2.0;

bool IsTerminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stdout)) != 0;
#else
  return isatty(STDOUT_FILENO) != 0;
#endif
}

// One line that changes in place on a terminal; elsewhere one line for each part of the tour.
class Progress
{
public:
  void Show(const std::string& change, int frame, int frames, const FrameRecord& record) const
  {
    const bool isLast = frame + 1 == frames;
    if (this->InPlace || isLast)
    {
      std::printf("%s%-10s %*d/%d  %-12s %7.1f ms%s", this->InPlace ? "\r" : "", change.c_str(), 3,
        frame + 1, frames, record.Route.c_str(), record.WallMs, isLast ? "\n" : "");
      std::fflush(stdout);
    }
  }

private:
  bool InPlace = IsTerminal();
};

class Tour
{
public:
  Tour(Scene& scene, const Options& options, PictureBook& book)
    : Shown(scene)
    , Asked(options)
    , Book(book)
  {
  }

  std::vector<FrameRecord> Records;

  // Without a caption the picture is not kept.
  void Render(const std::string& change, const std::string& caption, int frame, int frames)
  {
    vtkTemporalCoherenceVolumeMapper* mapper = this->Shown.Mapper;
    const double begin = vtkTimerLog::GetUniversalTime();
    const bool isMade = mapper->MakeImage(this->Shown.Renderer, this->Shown.Actor,
      this->Asked.Width, this->Asked.Height, this->Picture, nullptr);
    const double end = vtkTimerLog::GetUniversalTime();
    if (!isMade)
    {
      throw UserError("The mapper could not draw the volume; its message above says what to do.");
    }
    FrameRecord record;
    record.Change = change;
    record.Route = mapper->GetStatistics()->GetRouteAsString();
    record.WallMs = 1000.0 * (end - begin);
    record.TraceMs = 1000.0 * mapper->GetStatistics()->GetTraceTime();
    record.ShadeMs = 1000.0 * mapper->GetStatistics()->GetShadeTime();
    record.Rays = mapper->GetStatistics()->GetNumberOfRays();
    this->Records.push_back(record);

    if (!caption.empty())
    {
      std::ostringstream text;
      text << caption << "  " << record.Route << "  " << std::fixed << std::setprecision(1)
           << record.WallMs << " ms";
      this->Book.Add(this->Picture, change, frame, frames, text.str());
    }
    this->Reporter.Show(change, frame, frames, record);
  }

private:
  Scene& Shown;
  const Options& Asked;
  PictureBook& Book;
  Progress Reporter;
  vtkNew<vtkImageData> Picture;
};

std::string Caption(const std::string& before, double number, const std::string& after)
{
  std::ostringstream text;
  text.precision(4);
  text << before << number << after;
  return text.str();
}

// A row of its own in the table: what is made once for a volume is made here.
void RenderFirst(Tour& tour, Scene& scene, int orbitFrames)
{
  scene.SetAzimuth(-DegreesPerFrame * (orbitFrames + 1));
  tour.Render("first", "", 0, 1);
}

// What the rest of the tour is compared with: views that no earlier picture may help with. They
// are taken in several places of the tour, so that all of it meets the same load of the machine.
void RenderWithoutReuse(Tour& tour, Scene& scene, double lastAzimuth, int frames)
{
  scene.Mapper->ReuseFramesOff();
  scene.Mapper->IsomapOff();
  for (int frame = 0; frame < frames; ++frame)
  {
    scene.SetAzimuth(lastAzimuth + DegreesPerFrame * (frame + 1 - frames));
    tour.Render(WithoutReuse, "", frame, frames);
  }
  scene.Mapper->ReuseFramesOn();
  scene.Mapper->IsomapOn();
}

// Ends in front, where all that follows is seen from.
void Orbit(Tour& tour, Scene& scene, int frames)
{
  for (int frame = 0; frame < frames; ++frame)
  {
    const double azimuth = DegreesPerFrame * (frame + 1 - frames);
    scene.SetAzimuth(azimuth);
    tour.Render("orbit", Caption("", azimuth, " deg"), frame, frames);
  }
}

// Isovalues around one: as a slider is dragged: 3 % of the range below to 7 % above, inside it.
std::vector<double> SweepAround(const IsovalueChoice& isovalue, int count)
{
  const double width = isovalue.Range[1] - isovalue.Range[0];
  const double margin = 0.01 * width;
  const double begin = std::max(isovalue.Value - 0.03 * width, isovalue.Range[0] + margin);
  const double end = std::min(isovalue.Value + 0.07 * width, isovalue.Range[1] - margin);
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
  {
    values.push_back(begin + (end - begin) * i / std::max(count - 1, 1));
  }
  return values;
}

void Sweep(Tour& tour, Scene& scene, const IsovalueChoice& isovalue, int frames)
{
  const std::vector<double> values = SweepAround(isovalue, frames);
  for (int frame = 0; frame < frames; ++frame)
  {
    const double value = values[static_cast<std::size_t>(frame)];
    scene.SetIsovalue(value);
    tour.Render("threshold", Caption("isovalue ", value, ""), frame, frames);
  }
}

// Ends with the colour it began with.
void ChangeColors(Tour& tour, Scene& scene, int frames)
{
  for (int frame = 0; frame + 1 < frames; ++frame)
  {
    const double turn = 2.0 * vtkMath::Pi() * (frame + 1) / frames;
    scene.SetLowColor(0.5 + 0.4 * std::cos(turn), 0.5 + 0.4 * std::cos(turn - 2.1),
      0.5 + 0.4 * std::cos(turn - 4.2));
    tour.Render("colour", "colour", frame, frames);
  }
  scene.SetDefaultColor();
  tour.Render("colour", "colour", frames - 1, frames);
}

void Repeat(Tour& tour, int frames)
{
  for (int frame = 0; frame < frames; ++frame)
  {
    tour.Render("repeat", "", frame, frames);
  }
}

}

std::vector<FrameRecord> RunTour(
  Scene& scene, const IsovalueChoice& isovalue, const Options& options, PictureBook& book)
{
  Tour tour(scene, options, book);
  RenderFirst(tour, scene, options.OrbitFrames);
  // Last, the view before the orbit's first, and then the orbit's last.
  RenderWithoutReuse(
    tour, scene, -DegreesPerFrame * options.OrbitFrames, options.FramesWithoutReuse);
  Orbit(tour, scene, options.OrbitFrames);
  RenderWithoutReuse(tour, scene, 0.0, options.FramesWithoutReuse);
  Repeat(tour, options.RepeatFrames);
  ChangeColors(tour, scene, options.ColorFrames);
  Sweep(tour, scene, isovalue, options.SweepFrames);
  scene.SetIsovalue(isovalue.Value);
  RenderWithoutReuse(tour, scene, 0.0, options.FramesWithoutReuse);
  return tour.Records;
}
