// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsomapFrames.h"

#include "Measuring.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace IsomapFrames
{
namespace
{

constexpr double Degrees = 2.0; ///< of the orbit, a frame
/// The plain ray caster is slow: it gets fewer frames.
constexpr int FewestPlainFrames = 3;
/// New mappers whose first step is measured.
constexpr int NumberOfFirstSteps = 3;
constexpr double FirstStep = 1.0 / 256.0; ///< of the range of values: one of 8 bits
/// Where in the first step later isovalues lie: none is the last one again.
constexpr std::array<double, 5> WithinFirstStep = { 0.2, 0.8, 0.4, 1.0, 0.6 };

double PerPixel(vtkIdType number, const Stage& stage)
{
  return static_cast<double>(number) / (static_cast<double>(stage.Size) * stage.Size);
}

/// Frames of a moving camera, made with no help from the last; the first is not measured.
double ColdTime(Stage& stage, bool spaceLeaping, int frames)
{
  stage.ResetView();
  Drawer drawer(stage);
  drawer.Mapper->ReuseFramesOff();
  drawer.Mapper->SetSpaceLeaping(spaceLeaping);
  drawer.Draw(stage);
  std::vector<double> times;
  for (int frame = 0; frame < frames; ++frame)
  {
    stage.Orbit(Degrees);
    times.push_back(drawer.Draw(stage));
  }
  stage.ResetView();
  return Measuring::Median(times);
}

/// The first new isovalue of new mappers.
double FirstStepTime(Stage& stage, double isovalue, double step)
{
  std::vector<double> times;
  for (int i = 0; i < NumberOfFirstSteps; ++i)
  {
    Drawer drawer(stage);
    stage.SetIsovalue(isovalue);
    drawer.Draw(stage);
    stage.SetIsovalue(isovalue + step);
    times.push_back(drawer.Draw(stage));
  }
  stage.SetIsovalue(isovalue);
  return Measuring::Median(times);
}

/// Isovalues that one step has made known.
void MeasureLaterSteps(Stage& stage, double isovalue, double step, int frames, Times& times)
{
  Drawer lookup(stage);
  lookup.Draw(stage);
  stage.SetIsovalue(isovalue + step);
  lookup.Draw(stage);
  times.BytesAPixel = BytesAPixel(lookup, stage);
  std::vector<double> lookups, traces, shades;
  for (int frame = 0; frame < frames; ++frame)
  {
    const auto at = static_cast<std::size_t>(frame) % WithinFirstStep.size();
    stage.SetIsovalue(isovalue + WithinFirstStep[at] * step);
    const double time = lookup.Draw(stage);
    if (lookup.Route() == "IsomapLookup")
    {
      lookups.push_back(time);
      traces.push_back(1e3 * lookup.Mapper->GetStatistics()->GetTraceTime());
      shades.push_back(1e3 * lookup.Mapper->GetStatistics()->GetShadeTime());
    }
  }
  stage.SetIsovalue(isovalue);
  times.Lookup = Measuring::Median(lookups);
  times.LookupTrace = Measuring::Median(traces);
  times.LookupShade = Measuring::Median(shades);
}

}

Times MeasureStepUp(Stage& stage, int frames)
{
  const double isovalue = stage.Isovalue();
  const double step = stage.ShareOfRange(FirstStep);
  Times times;
  times.FirstUp = FirstStepTime(stage, isovalue, step);
  MeasureLaterSteps(stage, isovalue, step, frames, times);
  return times;
}

Times Measure(Stage& stage, int frames)
{
  Times times = MeasureStepUp(stage, frames);
  times.FirstDown = FirstStepTime(stage, stage.Isovalue(), -stage.ShareOfRange(FirstStep));
  times.Cold = ColdTime(stage, true, frames);
  times.Plain = ColdTime(stage, false, std::max(FewestPlainFrames, frames / 10));
  return times;
}

double BytesAPixel(const Drawer& drawer, const Stage& stage)
{
  return PerPixel(drawer.Mapper->GetStatistics()->GetIsomapMemory(), stage);
}

double KnotsAPixel(const Drawer& drawer, const Stage& stage)
{
  return PerPixel(drawer.Mapper->GetStatistics()->GetNumberOfIsomapKnots(), stage);
}

}
