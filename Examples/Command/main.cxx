// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws a volume without a window: the Explorer's pictures, from a command line.
#include "ColorBy.h"
#include "Files/Trial.h"
#include "Model/Model.h"
#include "Options.h"
#include "Pictures.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"
#include "View/Isovalue.h"

#include <vtkCamera.h>
#include <vtkTimerLog.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <utility>

namespace
{

// The outer surfaces, as a rule those of smaller values, let the others be seen.
std::vector<Marker> SurfacesOf(const Options& options)
{
  const auto of = [](const auto& values, std::size_t i)
  { return values[std::min(i, values.size() - 1)]; };
  std::vector<Marker> surfaces;
  const std::vector<double>& isovalues = options.Isovalues;
  for (std::size_t i = 0; i < isovalues.size(); ++i)
  {
    Marker surface{ isovalues[i] };
    const bool isInner = isovalues[i] == *std::max_element(isovalues.begin(), isovalues.end());
    surface.Opacity = !options.Opacities.empty() ? of(options.Opacities, i)
      : isInner                                  ? 1.0
                                                 : SeeThrough;
    if (!options.Colors.empty())
    {
      surface.Color = of(options.Colors, i);
    }
    else if (i > 0)
    {
      surface.Color = ContrastOf(i);
    }
    surfaces.push_back(surface);
  }
  if (surfaces.empty() && (!options.Opacities.empty() || !options.Colors.empty()))
  {
    surfaces.push_back({ 0.0, options.Opacities.empty() ? 1.0 : options.Opacities[0] });
    surfaces[0].Color =
      options.Colors.empty() ? std::optional<Rgb>() : std::optional<Rgb>(options.Colors[0]);
  }
  return surfaces;
}

Session SessionOf(const Options& options)
{
  Session session;
  session.Source = options.Source;
  session.Settings.Values[Row::Occlusion] = 0.0; // for speed
  if (IsSessionName(options.Source.Path))
  {
    session = ReadSession(options.Source.Path);
  }
  Look& look = session.Settings;
  for (const auto& [row, value] : options.Choices)
  {
    look.Values[row] = value;
  }
  if (options.ThresholdMode)
  {
    look.Values[Row::Surface] = vtkTemporalCoherenceVolumeMapper::THRESHOLD;
  }
  const std::vector<Marker> surfaces = SurfacesOf(options);
  look.Surfaces = surfaces.empty() ? look.Surfaces : surfaces;
  if (!options.Isovalues.empty())
  {
    session.Isovalue = options.Isovalues[0];
  }
  return session;
}

// What needs the values and the place of the volume.
void SetLook(Model& model, const Options& options)
{
  for (const double isovalue : options.Isovalues)
  {
    ChooseIsovalue(model.Counted(), isovalue, Quoted(model.Data().Name));
  }
  Look look = model.Settings();
  const std::vector<Setting>& settings = AllSettings();
  if (model.DrawsMesh() && look.Choice(Row::Drawing) != Drawing::Surfaces)
  {
    throw UserError(Quoted(model.Data().Name) +
      " is a mesh, of which only surfaces can be drawn; leave out --preset, --maximum, --minimum "
      "and --draw.");
  }
  if (look.Choice(Row::Drawing) == Drawing::Labels && model.Data().Bricks)
  {
    throw UserError("Labels of " + Quoted(model.Data().Name) +
      " are not drawn, as the volume is read as it is needed; leave out --draw labels.");
  }
  if (look.Choice(Row::Drawing) == Drawing::Labels && !model.CanBeLabels())
  {
    throw UserError("The samples of " + Quoted(model.Data().Name) +
      " cannot be labels, which are whole numbers of an image, at most 65535; leave out --draw "
      "labels.");
  }
  if (options.Preset)
  {
    model.SetChoice(look, Row::Preset, *options.Preset);
    const std::array<double, 2> shifts = model.RangeOf(settings[Row::Shift]);
    if (options.Shift < shifts[0] || options.Shift > shifts[1])
    {
      std::ostringstream what;
      what << "--shift takes a number from " << shifts[0] << " to " << shifts[1]
           << " for these values, not " << options.Shift << ".";
      throw UserError(what.str());
    }
    model.SetNumber(settings[Row::Shift], look, 0, options.Shift);
  }
  if (options.Window)
  {
    const std::array<double, 2>& range = model.Counted().Range;
    const double width = range[1] - range[0];
    const double black = *options.Level - 0.5 * *options.Window;
    const double white = *options.Level + 0.5 * *options.Window;
    if (black < range[0] - width || white > range[1] + width)
    {
      std::ostringstream what;
      what << "--window and --level must lie within " << range[0] - width << " to "
           << range[1] + width << "; these begin at " << black << " and end at " << white << ".";
      throw UserError(what.str());
    }
    model.SetNumber(settings[Row::Window], look, 0, *options.Window);
    model.SetNumber(settings[Row::Level], look, 0, *options.Level);
  }
  if (options.ClipAxis)
  {
    const Box& box = model.View.WorldBounds();
    const std::size_t axis = *options.ClipAxis;
    look.Values[Row::Clipping] = 1.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      look.Clip.Origin[i] = 0.5 * (box[2 * i] + box[2 * i + 1]);
      look.Clip.Normal[i] = i == axis ? (options.IsClipFlipped ? -1.0 : 1.0) : 0.0;
    }
    look.Clip.Origin[axis] = options.ClipAt.value_or(look.Clip.Origin[axis]);
  }
  look.ColorBy = options.ColorBy.empty() ? look.ColorBy : ColorByOf(model, options.ColorBy);
  if (!IsSessionName(options.Source.Path))
  {
    look.Values[Row::Brightness] = 0.0; // that of the first look
  }
  model.SetSettings(look);
}

void SetView(Model& model, const Options& options)
{
  vtkCamera* const camera = model.View.Renderer->GetActiveCamera();
  camera->Azimuth(options.Azimuth);
  camera->Elevation(options.Elevation);
  camera->OrthogonalizeViewUp();
  // The view is made for a square: all of it is seen in a narrower picture, too.
  const double narrow = std::min(1.0, 1.0 * options.Width / options.Height);
  const double zoom = options.Zoom * (model.State().HasCamera ? 1.0 : narrow);
  camera->Zoom(zoom);
}

// Samples on a plane, axes and text are drawn by OpenGL.
void CheckDisplay(const Model& model)
{
#if !defined(_WIN32) && !defined(__APPLE__)
  const char* const display = std::getenv("DISPLAY");
  if (model.View.HasAnnotations() && (!display || !*display))
  {
    throw UserError(
      "What is beside the volume is drawn by OpenGL, which needs a display, and DISPLAY "
      "is not set; leave it out, or run this under xvfb-run.");
  }
#endif
}

void Run(const Options& options)
{
  CheckOutput(options);
  const double begin = vtkTimerLog::GetUniversalTime();
  Model model(options.From, options.Up);
  model.Open(SessionOf(options));
  SetLook(model, options);
  CheckDisplay(model);
  SetView(model, options);
  const std::string remark = model.Data().Remark.empty() ? "" : "\n" + model.Data().Remark;
  std::printf("Volume: %s, %s, values %g to %g%s\n", model.Data().Name.c_str(),
    model.Description().c_str(), model.Counted().Range[0], model.Counted().Range[1],
    remark.c_str());
  if (model.HasIsovalues() && options.Isovalues.empty())
  {
    std::printf("Isovalue: %g (chosen from the histogram)\n", *model.State().Isovalue);
  }
  const std::string written = WritePictures(model, options);
  std::printf("%s\nTime: %.1f s\n", written.c_str(), vtkTimerLog::GetUniversalTime() - begin);
}

}

int main(int argc, char* argv[])
{
  BeginTrials();
  return RunProgram("temporal-coherence",
    [&]
    {
      const Options options = ParseOptions(argc, argv);
      if (options.Help)
      {
        std::fputs(HelpText().c_str(), stdout);
        return;
      }
      Run(options);
    });
}
