// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TypicalFrames.h"

#include "CacheFrames.h"
#include "IsomapFrames.h"
#include "Measuring.h"

#include <array>

namespace TypicalFrames
{
namespace
{

struct Column
{
  const char* Head;
  double Times::*Time;
};
constexpr std::array<Column, 5> Columns = { { { "cold", &Times::Cold },
  { "(shade)", &Times::ColdShade }, { "image cache", &Times::Cached },
  { "first new isovalue", &Times::First }, { "look-up", &Times::Lookup } } };

}

Times Measure(Stage& stage, int frames)
{
  using namespace CacheFrames;
  constexpr double degrees = 2.0;
  // Cold and BOUNDED.
  const std::vector<Variant> variants = { AllVariants()[0], AllVariants()[1] };
  const std::vector<Summary> orbit = Run(stage, Orbit(degrees), variants, frames);
  stage.ResetView();
  const IsomapFrames::Times step = IsomapFrames::MeasureStepUp(stage, frames);
  // Where a frame tells nothing of the next, there are none from the image cache.
  const double cached =
    orbit[1].FramesFromCache < 50.0 ? Measuring::None : orbit[1].Medians[FrameMs];
  return { orbit[0].Medians[FrameMs], orbit[0].Medians[ShadeMs], cached, orbit[1].FramesFromCache,
    step.FirstUp, step.Lookup };
}

MarkdownTable BeginComparison(const std::vector<std::string>& first)
{
  std::vector<std::string> head = first;
  for (const Column& column : Columns)
  {
    head.insert(head.end(), { column.Head, "speed-up" });
  }
  return MarkdownTable(head);
}

void PrintComparison(const MarkdownTable& table, const std::vector<std::string>& first,
  const Times& reference, const Times& times)
{
  std::vector<std::string> row = first;
  for (const Column& column : Columns)
  {
    const double time = times.*column.Time;
    row.push_back(Fixed(time, 1));
    row.push_back(Fixed(Measuring::Ratio(reference.*column.Time, time), 2));
  }
  table.Row(row);
}

void AddTo(JsonWriter& json, const Times& times)
{
  json.Add("coldMs", times.Cold);
  json.Add("coldShadeMs", times.ColdShade);
  json.Add("boundedMs", times.Cached);
  json.Add("framesFromCachePercent", times.PercentFromCache);
  json.Add("firstStepUpMs", times.First);
  json.Add("lookupMs", times.Lookup);
}

}
