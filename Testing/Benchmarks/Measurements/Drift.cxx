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

/// Both accuracies on one orbit, held against the same cold pictures.
std::array<Course, 2> RunOrbit(Stage& stage, double degrees, int frames)
{
  Drawer cold(stage), paper(stage), bounded(stage);
  cold.Mapper->ImageCacheOff();
  paper.Mapper->RefineWhenStillOff();
  paper.Mapper->SetReuseAccuracyToPaper();
  bounded.Mapper->RefineWhenStillOff();
  bounded.Mapper->SetReuseAccuracyToBounded();

  std::array<Course, 2> courses = { Course{ "PAPER", degrees, {}, {} },
    Course{ "BOUNDED", degrees, {}, {} } };
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
    courses[0].Frames.push_back(frame);
    courses[0].Different.push_back(PercentDifferent(paper, cold, stage));
    courses[1].Frames.push_back(frame);
    courses[1].Different.push_back(PercentDifferent(bounded, cold, stage));
  }
  return courses;
}

}

std::vector<Course> Run(Stage& stage, int frames)
{
  std::vector<Course> courses;
  for (const double degrees : AllDegrees)
  {
    for (const Course& course : RunOrbit(stage, degrees, frames))
    {
      courses.push_back(course);
    }
  }
  return courses;
}

void PrintTable(const std::vector<Course>& courses)
{
  std::vector<std::string> head = { "accuracy", "degrees a frame" };
  for (const int frame : Milestones)
  {
    head.push_back("% after " + Plain(frame));
  }
  head.insert(head.end(), { "median", "worst" });
  const MarkdownTable table(head);
  for (const Course& course : courses)
  {
    std::vector<std::string> cells = { course.Accuracy, Plain(course.Degrees) };
    for (const int milestone : Milestones)
    {
      const auto at = std::find(course.Frames.begin(), course.Frames.end(), milestone);
      cells.push_back(at == course.Frames.end()
          ? "-"
          : Fixed(course.Different[static_cast<std::size_t>(at - course.Frames.begin())], 4));
    }
    cells.push_back(Fixed(Measuring::Median(course.Different), 4));
    cells.push_back(Fixed(Measuring::Worst(course.Different), 4));
    table.Row(cells);
  }
}

void AddTo(JsonWriter& json, const std::vector<Course>& courses)
{
  json.OpenList("drift");
  for (const Course& course : courses)
  {
    json.OpenObject();
    json.Add("accuracy", course.Accuracy);
    json.Add("degreesAFrame", course.Degrees);
    json.OpenList("comparisons");
    for (std::size_t i = 0; i < course.Frames.size(); ++i)
    {
      json.OpenObject();
      json.Add("frame", course.Frames[i]);
      json.Add("differentPixelsPercent", course.Different[i]);
      json.Close();
    }
    json.Close();
    json.Close();
  }
  json.Close();
}

}
