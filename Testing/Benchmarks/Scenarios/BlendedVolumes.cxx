// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Blended volumes: the mapper beside VTK's mappers, in the same run and views.

#include "BlendFrames.h"
#include "Display.h"
#include "Measuring.h"
#include "Scenario.h"

#include <vtkVolumeMapper.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{

using Measuring::Ratio;

constexpr int UsualRounds = 5;

const char* const ChangeNames[] = { "viewMs", "rampMs", "colorMs", "lightMs" };

/// The volumes that were asked for, or the usual ones. Those of others have no second value.
std::vector<BlendLooks::Subject> SubjectsOf(const Settings& settings)
{
  const std::vector<BlendLooks::Subject>& all = BlendLooks::Subjects();
  if (settings.Volumes.empty())
  {
    return settings.IsQuick ? std::vector<BlendLooks::Subject>{ all.front() } : all;
  }
  std::vector<BlendLooks::Subject> asked;
  for (const Volumes::Sample& volume : settings.Volumes)
  {
    const auto known = std::find_if(all.begin(), all.end(),
      [&](const BlendLooks::Subject& subject) { return subject.Volume == volume.Name; });
    asked.push_back(known != all.end()
        ? *known
        : BlendLooks::Subject{ volume.Name, volume.Isovalue, Measuring::None });
  }
  return asked;
}

void AddTo(JsonWriter& json, const BlendFrames::Figures& figures)
{
  json.OpenObject();
  json.Add("who", figures.Who);
  for (std::size_t change = 0; change < BlendFrames::Changes; ++change)
  {
    json.Add(ChangeNames[change], figures.Times[change]);
  }
  json.Add("meanError", figures.Errors.Mean);
  json.Add("mostError", figures.Errors.MostPixels);
  json.Add("percentBeyondOne", figures.Errors.PercentBeyondOne);
  json.Close();
}

/// A time, and how it compares with our cold frame of that change.
std::string CellOf(double time, double cold)
{
  return Fixed(time, 1) + " (" + Fixed(Ratio(time, cold), 2) + ")";
}

void Report(const MarkdownTable& table, JsonWriter& json, const std::string& volume,
  const std::string& look, const std::vector<BlendFrames::Figures>& all)
{
  json.OpenObject();
  json.Add("volume", volume);
  json.Add("look", look);
  json.OpenList("ways");
  for (const BlendFrames::Figures& figures : all)
  {
    std::vector<std::string> row{ volume, look, figures.Who };
    for (std::size_t change = 0; change < BlendFrames::Changes; ++change)
    {
      row.push_back(CellOf(figures.Times[change], all.front().Times[change]));
    }
    row.insert(row.end(),
      { Fixed(figures.Errors.Mean, 2), Fixed(figures.Errors.MostPixels, 1),
        Fixed(figures.Errors.PercentBeyondOne, 2) });
    table.Row(row);
    AddTo(json, figures);
  }
  json.Close();
  json.Close();
}

bool Run(const Settings& settings, JsonWriter& json)
{
  const bool hasWindow = HasDisplayOrTell("Peers that draw in a window are");
  const int rounds = settings.FramesOr(UsualRounds);
  std::cout << "Medians in ms (by our cold frame) of " << rounds
            << " frames after a change: of the view by a degree, of the lower end of the ramp, of "
               "colours, of light; errors from the integral in 1/255: mean, 99.9 %, and % of the "
               "pixels beyond 1; MIP: maximum intensity\n\n";
  const MarkdownTable table(
    { "volume", "look", "who", "view", "ramp", "colour", "light", "mean", "99.9 %", "> 1, %" });
  json.OpenList("volumes");
  bool isMeasured = false;
  for (BlendLooks::Subject subject : SubjectsOf(settings))
  {
    const vtkSmartPointer<vtkImageData> image = LoadOrTell(subject.Volume);
    if (!image)
    {
      continue;
    }
    const double* range = image->GetScalarRange();
    subject.Hard = std::isnan(subject.Hard) ? 0.5 * (subject.Soft + range[1]) : subject.Hard;
    const std::vector<BlendLooks::Look> looks = BlendLooks::Of(subject, { range[0], range[1] });
    for (const BlendLooks::Look& look : looks)
    {
      std::cerr << "  " << subject.Volume << ", " << look.Name << std::endl;
      Stage stage(image, subject.Soft, settings.Size, settings.From);
      Report(table, json, subject.Volume, look.Name,
        BlendFrames::Measure(stage, look, vtkVolumeMapper::COMPOSITE_BLEND, rounds, hasWindow));
    }
    Stage stage(image, subject.Soft, settings.Size, settings.From);
    Report(table, json, subject.Volume, "MIP",
      BlendFrames::Measure(
        stage, looks.front(), vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, rounds, hasWindow));
    isMeasured = true;
  }
  json.Close();
  return isMeasured;
}

}

Scenario Scenarios::BlendedVolumes()
{
  return { "volumes", "blended volumes: this mapper beside VTK's volume mappers", Run };
}
