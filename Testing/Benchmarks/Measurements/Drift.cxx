// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drift.h"

#include "Measuring.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace Drift
{
namespace
{

constexpr std::array<double, 3> AllDegrees = { 0.5, 1.0, 5.0 };
constexpr std::array<int, 4> Milestones = { 20, 180, 360, LongRun };

Curve RunOrbit(Stage& stage, double degrees, int frames)
{
  Drawer cold(stage), paper(stage);
  cold.Mapper->ReuseFramesOff();
  paper.Mapper->RefineWhenStillOff();
  paper.Mapper->SetReuseAccuracyToPaper();
  Curve curve{ degrees, {}, {} };
  stage.ResetView();
  paper.Draw(stage);
  for (int frame = 1; frame <= frames; ++frame)
  {
    stage.Orbit(degrees);
    paper.Draw(stage);
    if (frame % Stride == 0)
    {
      cold.Draw(stage);
      curve.Frames.push_back(frame);
      curve.Different.push_back(PercentDifferent(paper, cold, stage));
    }
  }
  return curve;
}

}

std::vector<Curve> Run(Stage& stage, int frames)
{
  std::vector<Curve> curves;
  for (const double degrees : AllDegrees)
  {
    curves.push_back(RunOrbit(stage, degrees, frames));
  }
  return curves;
}

void PrintTable(const std::vector<Curve>& curves)
{
  std::vector<std::string> head = { "degrees a frame" };
  for (const int frame : Milestones)
  {
    head.push_back("% after " + Plain(frame));
  }
  head.insert(head.end(), { "median", "worst" });
  const MarkdownTable table(head);
  for (const Curve& curve : curves)
  {
    std::vector<std::string> cells = { Plain(curve.Degrees) };
    for (const int milestone : Milestones)
    {
      const auto at = std::find(curve.Frames.begin(), curve.Frames.end(), milestone);
      cells.push_back(at == curve.Frames.end()
          ? "-"
          : Fixed(curve.Different[static_cast<std::size_t>(at - curve.Frames.begin())], 4));
    }
    cells.push_back(Fixed(Measuring::Median(curve.Different), 4));
    cells.push_back(Fixed(Measuring::Worst(curve.Different), 4));
    table.Row(cells);
  }
}

void AddTo(JsonWriter& json, const std::vector<Curve>& curves)
{
  json.OpenList("drift");
  for (const Curve& curve : curves)
  {
    json.OpenObject();
    json.Add("degreesAFrame", curve.Degrees);
    json.OpenList("comparisons");
    for (std::size_t i = 0; i < curve.Frames.size(); ++i)
    {
      json.OpenObject();
      json.Add("frame", curve.Frames[i]);
      json.Add("differentPixelsPercent", curve.Different[i]);
      json.Close();
    }
    json.Close();
    json.Close();
  }
  json.Close();
}

}
