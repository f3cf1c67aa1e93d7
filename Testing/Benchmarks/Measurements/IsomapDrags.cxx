// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsomapDrags.h"

#include "IsomapFrames.h"
#include "Measuring.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace IsomapDrags
{
namespace
{

constexpr double LargeStep = 0.004; ///< of the range of values
constexpr double SmallStep = 0.001;

/// What was measured of each step.
struct Steps
{
  std::vector<double> Times, ColdTimes;
  int NumberBuilt = 0;
  int NumberDifferent = 0;
};

/// Two mappers go the same way, and the faster counts: the slowest frame is to be a frame that
/// takes long, not one that something else kept from the processor.
Steps Drag(Stage& stage, const Path& path, std::array<Drawer, 2>& drawers, Drawer& cold)
{
  Steps steps;
  stage.SetIsovalue(path.Isovalues.front());
  for (Drawer& drawer : drawers)
  {
    drawer.Draw(stage);
  }
  cold.Draw(stage);
  for (std::size_t i = 1; i < path.Isovalues.size(); ++i)
  {
    stage.SetIsovalue(path.Isovalues[i]);
    steps.ColdTimes.push_back(cold.DrawCold(stage));
    const double first = drawers[0].Draw(stage);
    const double second = drawers[1].Draw(stage);
    steps.Times.push_back(std::min(first, second));
    steps.NumberBuilt += drawers[0].Route() == "IsomapBuild" ? 1 : 0;
    steps.NumberDifferent += AreIdentical(drawers[0], cold) ? 0 : 1;
  }
  return steps;
}

/// The median of a value and its neighbours, of which one may have been disturbed.
std::vector<double> Smoothed(const std::vector<double>& values)
{
  std::vector<double> medians;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const auto begin =
      values.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(i, 1) - 1);
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(std::min(i + 2, values.size()));
    medians.push_back(Measuring::Median({ begin, end }));
  }
  return medians;
}

}

std::vector<Path> AllPaths(const Stage& stage, int steps)
{
  Path up{ "up", {} }, down{ "down", {} }, around{ "around", {} };
  for (int i = 0; i <= steps; ++i)
  {
    const double fromMiddle = LargeStep * (i - 0.5 * steps);
    up.Isovalues.push_back(stage.IsovalueAt(0.5 + fromMiddle));
    down.Isovalues.push_back(stage.IsovalueAt(0.5 - fromMiddle));
    // A quarter of the way up, half of it down, a quarter back.
    const int quarter = steps / 4;
    const int fromBegin = i <= quarter ? i : i <= 3 * quarter ? 2 * quarter - i : i - 4 * quarter;
    around.Isovalues.push_back(stage.Isovalue() + stage.ShareOfRange(SmallStep * fromBegin));
  }
  return { up, down, around };
}

Summary Run(Stage& stage, const Path& path)
{
  const double isovalue = stage.Isovalue();
  std::array<Drawer, 2> drawers = { Drawer(stage), Drawer(stage) };
  Drawer cold(stage);
  const Steps steps = Drag(stage, path, drawers, cold);
  stage.SetIsovalue(isovalue);

  Summary summary;
  summary.Path = path.Name;
  summary.Steps = static_cast<int>(steps.Times.size());
  summary.PercentBuilt = 100.0 * Measuring::Ratio(steps.NumberBuilt, summary.Steps);
  summary.MedianMs = Measuring::Median(steps.Times);
  summary.MeanMs = Measuring::Mean(steps.Times);
  summary.WorstMs = Measuring::Worst(steps.Times);
  summary.ColdMs = Measuring::Median(steps.ColdTimes);
  summary.MeanByCold = Measuring::Ratio(summary.MeanMs, Measuring::Mean(steps.ColdTimes));
  summary.BytesAPixel = IsomapFrames::BytesAPixel(drawers[0], stage);
  summary.Different = steps.NumberDifferent;
  const std::vector<double> coldTimes = Smoothed(steps.ColdTimes);
  for (std::size_t i = 0; i < steps.Times.size(); ++i)
  {
    const double byCold = Measuring::Ratio(steps.Times[i], coldTimes[i]);
    if (byCold > summary.WorstByCold)
    {
      summary.WorstByCold = byCold;
      summary.WorstAt = path.Isovalues[i + 1];
    }
  }
  return summary;
}

}
