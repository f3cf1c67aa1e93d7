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
constexpr std::array<Column, 4> Columns = { { { "cold", &Times::Cold },
  { "(shade)", &Times::ColdShade }, { "first new isovalue", &Times::First },
  { "look-up", &Times::Lookup } } };

}

Times Measure(Stage& stage, int frames)
{
  using namespace CacheFrames;
  constexpr double degrees = 2.0;
  const std::vector<Variant> cold = { AllVariants().front() };
  const Summary orbit = Run(stage, Orbit(degrees), cold, frames).front();
  stage.ResetView();
  const IsomapFrames::Times step = IsomapFrames::MeasureStepUp(stage, frames);
  return { orbit.Medians[FrameMs], orbit.Medians[ShadeMs], step.FirstUp, step.Lookup };
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
  json.Add("firstStepUpMs", times.First);
  json.Add("lookupMs", times.Lookup);
}

}
