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

/// Both accuracies on one orbit, compared with the same cold pictures.
std::array<Curve, 2> RunOrbit(Stage& stage, double degrees, int frames)
{
  Drawer cold(stage), paper(stage), bounded(stage);
  cold.Mapper->ImageCacheOff();
  paper.Mapper->RefineWhenStillOff();
  paper.Mapper->SetReuseAccuracyToPaper();
  bounded.Mapper->RefineWhenStillOff();
  bounded.Mapper->SetReuseAccuracyToBounded();

  std::array<Curve, 2> curves = { Curve{ "PAPER", degrees, {}, {} },
    Curve{ "BOUNDED", degrees, {}, {} } };
  stage.ResetView();
  paper.Draw(stage);
  bounded.Draw(stage);
  for (int frame = 1; frame <= frames; ++frame)
  {
    stage.Orbit(degrees);
    paper.Draw(stage);
    bounded.Draw(stage);
    if (frame % Stride != 0)
    {
      continue;
    }
    cold.Draw(stage);
    curves[0].Frames.push_back(frame);
    curves[0].Different.push_back(PercentDifferent(paper, cold, stage));
    curves[1].Frames.push_back(frame);
    curves[1].Different.push_back(PercentDifferent(bounded, cold, stage));
  }
  return curves;
}

}

std::vector<Curve> Run(Stage& stage, int frames)
{
  std::vector<Curve> curves;
  for (const double degrees : AllDegrees)
  {
    for (const Curve& curve : RunOrbit(stage, degrees, frames))
    {
      curves.push_back(curve);
    }
  }
  return curves;
}

void PrintTable(const std::vector<Curve>& curves)
{
  std::vector<std::string> head = { "accuracy", "degrees a frame" };
  for (const int frame : Milestones)
  {
    head.push_back("% after " + Plain(frame));
  }
  head.insert(head.end(), { "median", "worst" });
  const MarkdownTable table(head);
  for (const Curve& curve : curves)
  {
    std::vector<std::string> cells = { curve.Accuracy, Plain(curve.Degrees) };
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
    json.Add("accuracy", curve.Accuracy);
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
