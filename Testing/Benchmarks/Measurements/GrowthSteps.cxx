// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GrowthSteps.h"

#include "Checks/ProcessMemory.h"
#include "Measuring.h"
#include "Volumes/Volumes.h"

#include <iostream>

namespace GrowthSteps
{
namespace
{

constexpr double Degrees = 2.0;
constexpr double IsovalueStep = 1.0 / 256.0; ///< of the range of values
constexpr double MiB = 1024.0 * 1024.0;

Memory MeasureMemory(Stage& stage)
{
  const double isovalue = stage.Isovalue();
  const double step = stage.ShareOfRange(IsovalueStep);
  Memory memory;
  memory.Volume = static_cast<double>(stage.Image->GetNumberOfPoints()) *
    stage.Image->GetNumberOfScalarComponents() * stage.Image->GetScalarSize();
  const double before = ProcessMemory::Resident();
  const bool isPeakOfThis = ProcessMemory::ResetPeak();
  Drawer drawer(stage);
  drawer.Draw(stage);
  memory.FirstFrame = ProcessMemory::Resident() - before;
  stage.Orbit(Degrees);
  drawer.Draw(stage);
  stage.SetIsovalue(isovalue + step);
  drawer.Draw(stage);
  stage.SetIsovalue(isovalue);
  stage.ResetView();
  memory.Reuse = ProcessMemory::Resident() - before;
  memory.Isomap = static_cast<double>(drawer.Mapper->GetStatistics()->GetIsomapMemory());
  memory.Peak = isPeakOfThis ? ProcessMemory::Peak() - before : Measuring::None;
  return memory;
}

Step Measure(
  const Volumes::Sample& object, int samplesASide, int pixels, const Framing& framing, int frames)
{
  std::cerr << "  " << object.Name << ' ' << samplesASide << "^3, " << pixels << "^2 pixels"
            << std::endl;
  Stage stage(
    Volumes::Load(object.Name + std::to_string(samplesASide)), object.Isovalue, pixels, framing);
  Step step;
  step.Object = object.Name;
  step.SamplesASide = samplesASide;
  step.Pixels = pixels;
  step.Memory = MeasureMemory(stage);
  step.Frames = TypicalFrames::Measure(stage, frames);
  return step;
}

std::string InMiB(double bytes)
{
  return Fixed(bytes / MiB, 1);
}

std::vector<std::string> BeginRow(const Step& step)
{
  return { step.Object, Plain(step.SamplesASide) + "^3", Plain(step.Pixels) + "^2" };
}

}

std::vector<Step> MeasureVoxels(int pixels, const Framing& framing, int largest, int frames)
{
  std::vector<Step> steps;
  for (const Volumes::Sample& object :
    { Volumes::Sample{ "spheres", 100 }, Volumes::Sample{ "marschner-lobb", 128 } })
  {
    for (int n = Smallest; n <= largest; n *= 2)
    {
      steps.push_back(Measure(object, n, pixels, framing, frames));
    }
  }
  return steps;
}

std::vector<Step> MeasurePixels(int pixels, const Framing& framing, int frames)
{
  constexpr int samplesASide = 256;
  std::vector<Step> steps;
  for (const int size : { (pixels + 1) / 2, pixels, 2 * pixels })
  {
    steps.push_back(Measure({ "spheres", 100 }, samplesASide, size, framing, frames));
  }
  return steps;
}

void PrintTimes(const std::vector<Step>& steps)
{
  const MarkdownTable table({ "object", "samples", "pixels", "cold", "growth", "first new isovalue",
    "growth", "look-up", "growth" });
  const Step* last = nullptr;
  for (const Step& step : steps)
  {
    std::vector<std::string> row = BeginRow(step);
    for (double TypicalFrames::Times::*time :
      { &TypicalFrames::Times::Cold, &TypicalFrames::Times::First, &TypicalFrames::Times::Lookup })
    {
      const bool isFirst = !last || last->Object != step.Object;
      row.push_back(Fixed(step.Frames.*time, 1));
      row.push_back(Fixed(isFirst ? Measuring::None : step.Frames.*time / (last->Frames.*time), 2));
    }
    table.Row(row);
    last = &step;
  }
}

void PrintMemory(const std::vector<Step>& steps)
{
  const MarkdownTable table({ "object", "samples", "pixels", "volume", "first frame",
    "cache and isomap too", "(isomap)", "most", "most / volume" });
  for (const Step& step : steps)
  {
    const Memory& m = step.Memory;
    std::vector<std::string> row = BeginRow(step);
    row.insert(row.end(),
      { InMiB(m.Volume), InMiB(m.FirstFrame), InMiB(m.Reuse), InMiB(m.Isomap), InMiB(m.Peak),
        Fixed(m.Peak / m.Volume, 2) });
    table.Row(row);
  }
}

void AddTo(JsonWriter& json, const std::string& name, const std::vector<Step>& steps)
{
  json.OpenList(name);
  for (const Step& step : steps)
  {
    json.OpenObject();
    json.Add("object", step.Object);
    json.Add("samplesASide", step.SamplesASide);
    json.Add("pixels", step.Pixels);
    TypicalFrames::AddTo(json, step.Frames);
    json.Add("volumeBytes", step.Memory.Volume);
    json.Add("firstFrameBytes", step.Memory.FirstFrame);
    json.Add("reuseBytes", step.Memory.Reuse);
    json.Add("isomapBytes", step.Memory.Isomap);
    json.Add("peakBytes", step.Memory.Peak);
    json.Close();
  }
  json.Close();
}

}
