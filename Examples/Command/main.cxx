// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws a volume into a picture or a film, without a window.
#include "Files/Trial.h"
#include "Model/Film.h"
#include "Options.h"
#include "Program/Quoted.h"
#include "Program/StatusLine.h"
#include "Program/UserError.h"
#include "Scene.h"
#include "Target.h"
#include "View/Picture.h"

#include <vtkTimerLog.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace
{

const char* const Name = "temporal-coherence";
constexpr int UsualFrames = 100;
constexpr int UsualRate = 25; // a second

// Returns what it made, for people: "Picture: brain.png, 1024 x 1024 pixels".
std::string DrawPicture(Scene& scene, const std::filesystem::path& target, StatusLine& status)
{
  const vtkSmartPointer<vtkImageData> picture = scene.Picture(
    [&](double share)
    {
      status.Show("Drawing", share);
      return true;
    });
  WritePng(picture, target.string(), OutputRemedy);
  return "Picture: " + Printable(target.string()) + ", ";
}

std::string DrawFilm(
  Scene& scene, const std::filesystem::path& target, const Options& options, StatusLine& status)
{
  const int frames = options.Frames.value_or(UsualFrames);
  const int rate = options.Rate.value_or(UsualRate);
  // A turn ends one step before it begins again.
  const int steps = options.Film == "turn" ? frames : std::max(frames - 1, 1);
  Film film(target, rate, OutputRemedy);
  for (int frame = 0; frame < frames; ++frame)
  {
    scene.MoveTo(1.0 * frame / steps);
    film.Add(scene.Picture(
      [&](double share)
      {
        status.Show("Drawing", (frame + share) / frames);
        return true;
      }));
  }
  film.End();
  const std::string speed =
    Film::IsFilmName(target) ? ", " + std::to_string(rate) + " a second" : "";
  return "Film: " + Printable(target.string()) + ", " + std::to_string(frames) +
    (frames == 1 ? " frame" : " frames") + speed + ", ";
}

void Run(const Options& options)
{
  const std::filesystem::path target = TargetOf(options);
  StatusLine status;
  Scene scene(options,
    [&](double share)
    {
      status.Show("Reading", share);
      return true;
    });
  const double begin = vtkTimerLog::GetUniversalTime();
  const std::string made = options.IsFilm() ? DrawFilm(scene, target, options, status)
                                            : DrawPicture(scene, target, status);
  const double seconds = vtkTimerLog::GetUniversalTime() - begin;
  status.Show("");
  std::printf("%s\n%s%d x %d pixels, %s, made in %.3g s\n", scene.Description().c_str(),
    made.c_str(), options.Width, options.Height, SizeForPeople(target).c_str(), seconds);
  for (const std::string& remark : scene.Remarks())
  {
    std::printf("%s\n", Printable(remark).c_str());
  }
}

}

int main(int argc, char* argv[])
{
  BeginTrials();
  return RunProgram(Name,
    [&]
    {
      const Options options = ParseOptions(argc, argv);
      if (options.Help)
      {
        std::fputs(HelpText().c_str(), stdout);
      }
      else if (options.WantsVersion)
      {
        std::printf("%s %s\n", Name, COMMAND_VERSION);
      }
      else
      {
        Run(options);
      }
    });
}
