// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Composite volumes whose colours jump where their opacity does not: how far pictures are from the
// integral, and what frames cost.

#include "BlendErrors.h"
#include "BlendLooks.h"
#include "BlendWays.h"
#include "Measuring.h"
#include "Scenario.h"

#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace
{

using BlendLooks::Look;

constexpr int UsualFrames = 5;
constexpr double Degrees = 1.0; ///< from frame to frame

/// Pictures whose pixels are about so many times as wide: their rays do not go as beams.
constexpr int Coarse = 8;

/// At most so many pixels of a picture are compared.
constexpr std::size_t MostCompared = 4096, MostComparedIfQuick = 128;

/// All points of functions lie at multiples of this part of the range, and so at nodes of the
/// mapper's and of the integral's tables.
constexpr double Grid = 1.0 / 1024.0;

constexpr std::array<double, 3> Red{ 1.0, 0.0, 0.0 }, Cyan{ 0.0, 1.0, 1.0 };

/// A look, and in how many steps of the grid its colours change; 0: they do not jump.
struct Case
{
  Look Shown;
  int Width;
};

/// Adds points at places in the grid.
class Builder
{
public:
  Builder(const std::string& name, const std::array<double, 2>& range)
    : Range(range)
  {
    this->Made.Name = name;
  }

  Builder& At(int place, const std::array<double, 3>& color, double opacity)
  {
    const double value = this->Range[0] + place * Grid * (this->Range[1] - this->Range[0]);
    this->Made.Points.push_back({ value, { color[0], color[1], color[2], opacity } });
    return *this;
  }

  Look Made;

private:
  const std::array<double, 2> Range;
};

/// Fog everywhere, red or cyan.
Look Fog(int width, const std::array<double, 2>& range)
{
  constexpr double opacity = 0.05;
  return Builder("fog", range)
    .At(0, Red, opacity)
    .At(384, Red, opacity)
    .At(384 + width, Cyan, opacity)
    .At(1024, Cyan, opacity)
    .Made;
}

/// Nothing but values around the middle: red on the outer side, cyan on the inner one.
Look Shell(int width, const std::array<double, 2>& range)
{
  constexpr double opacity = 0.7;
  return Builder("shell", range)
    .At(0, Red, 0.0)
    .At(256, Red, 0.0)
    .At(320, Red, opacity)
    .At(384, Red, opacity)
    .At(384 + width, Cyan, opacity)
    .At(512, Cyan, opacity)
    .At(576, Cyan, 0.0)
    .At(1024, Cyan, 0.0)
    .Made;
}

/// Red and cyan by turns.
Look Stripes(int width, const std::array<double, 2>& range)
{
  constexpr double opacity = 0.3;
  Builder stripes("stripes", range);
  stripes.At(0, Red, opacity);
  for (int stripe = 1; stripe < 8; ++stripe)
  {
    const bool isRed = stripe % 2 == 0;
    stripes.At(128 * stripe, isRed ? Cyan : Red, opacity);
    stripes.At(128 * stripe + width, isRed ? Red : Cyan, opacity);
  }
  return stripes.At(1024, Cyan, opacity).Made;
}

/// Functions with jumps of several widths, and the usual ones.
std::vector<Case> CasesOf(const Volumes::Sample& volume, vtkImageData* image)
{
  const std::array<double, 2> range{ image->GetScalarRange()[0], image->GetScalarRange()[1] };
  std::vector<Case> cases;
  for (const auto& make : { Fog, Shell, Stripes })
  {
    for (const int width : { 1, 8, 64 })
    {
      cases.push_back({ make(width, range), width });
    }
  }
  const double hard = 0.5 * (volume.Isovalue + range[1]);
  for (const Look& look : BlendLooks::Of({ volume.Name, volume.Isovalue, hard }, range))
  {
    cases.push_back({ look, 0 });
  }
  return cases;
}

/// How near pictures are, and the least time of a frame.
struct Figures
{
  BlendErrors::Errors Errors;
  double CpuMs;
};

Figures Measure(Stage& stage, const Look& look, int frames, std::size_t mostCompared)
{
  vtkVolumeProperty* property = stage.Volume->GetProperty();
  property->ShadeOff();
  property->SetScalarOpacityUnitDistance(stage.VoxelSize());
  BlendLooks::Apply(look, property);
  stage.ResetView();
  const auto ways = BlendWays::All(stage, vtkVolumeMapper::COMPOSITE_BLEND, false);
  BlendWays::Way& cold = *ways.front();
  cold.Draw(stage);
  const BlendWays::Picture picture = cold.Shown();
  // Odd, so that columns change from row to row.
  const std::size_t stride = (picture.size() + mostCompared - 1) / mostCompared | 1u;
  const BlendErrors::Truth truth(stage, look, vtkVolumeMapper::COMPOSITE_BLEND, stride);
  const BlendErrors::Errors errors = truth.Of(picture);
  double least = std::numeric_limits<double>::infinity();
  for (int frame = 0; frame < frames; ++frame)
  {
    cold.BeforeChange(stage);
    stage.Orbit(Degrees);
    const double begin = Measuring::CpuTime();
    cold.Draw(stage);
    least = std::min(least, Measuring::CpuTime() - begin);
  }
  return { errors, least };
}

void Report(const MarkdownTable& table, JsonWriter& json, const std::string& volume, int size,
  const Case& measured, const Figures& figures)
{
  const double width = measured.Width * Grid;
  table.Row({ volume, std::to_string(size), measured.Shown.Name,
    measured.Width > 0 ? Fixed(100.0 * width, 1) : "-", Fixed(figures.Errors.PercentBeyondOne, 2),
    Fixed(figures.Errors.Largest, 2), Fixed(figures.CpuMs, 1) });
  json.OpenObject();
  json.Add("size", size);
  json.Add("look", measured.Shown.Name);
  json.Add("width", width);
  json.Add("percentBeyondOne", figures.Errors.PercentBeyondOne);
  json.Add("largestError", figures.Errors.Largest);
  json.Add("cpuMs", figures.CpuMs);
  json.Close();
}

bool Run(const Settings& settings, JsonWriter& json)
{
  const int frames = settings.FramesOr(UsualFrames);
  std::cout << "Without light. Ramp: % of the range of values in which colours change. Errors from "
               "the integral, in 1/255 and with rounding: % of the pixels beyond 1, and the "
               "largest. Least CPU time in ms of "
            << frames << " cold frames\n\n";
  const MarkdownTable table(
    { "volume", "pixels", "look", "ramp, %", "> 1, %", "largest", "CPU ms" });
  return ReportVolumes(settings, { { "marschner-lobb64", 128 }, { "engine.vti", 70 } }, json,
    [&](const Volumes::Sample& volume, Stage& given)
    {
      json.OpenList("looks");
      for (const int size : { std::max(settings.Size / Coarse, 1), settings.Size })
      {
        Stage stage(given.Data, volume.Isovalue, size, settings.From);
        for (const Case& look : CasesOf(volume, stage.Image))
        {
          Report(table, json, volume.Name, size, look,
            Measure(
              stage, look.Shown, frames, settings.IsQuick ? MostComparedIfQuick : MostCompared));
        }
      }
      json.Close();
    });
}

}

Scenario Scenarios::ColorJumps()
{
  return { "jumps", "composite volumes whose colours jump: errors and CPU time", Run };
}
