// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFrames.h"

#include "Measuring.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace MeshFrames
{
namespace
{

using MeshPeers::Subject;
using MeshPeers::Way;

constexpr double Degrees = 2.0; ///< of the orbit, a round
/// The first new isovalue of a view is this share of the range away; those after it lie between.
constexpr double FirstStep = 1.0 / 256.0;
constexpr int LaterSteps = 8; ///< of ours, which learns as it goes: the last half counts
constexpr int LaterStepsOfPeers = 2;
constexpr int StepsInRange = 5;

/// What is measured of one way.
struct Samples
{
  std::vector<double> Cold, NewView, First, Later, InRange;
  double First0 = 0.0; ///< of the very first frame
  int LookedUp = 0;
};

/// Compare a picture of the mapper with that of the mesh.
void Compare(const Way& ours, const Way& other, const Stage& stage, Times& times)
{
  times.PercentWrong = times.DepthOff = times.DepthFarOff = Measuring::None;
  if (!other.Ours() || &ours == &other)
  {
    return;
  }
  const auto depthsOf = [](const Way& way)
  { return static_cast<const float*>(way.Ours()->Depth->GetScalarPointer()); };
  const float *a = depthsOf(ours), *b = depthsOf(other);
  const vtkIdType pixels = ours.Ours()->Depth->GetNumberOfPoints();
  std::vector<double> apart;
  vtkIdType wrong = 0;
  for (vtkIdType i = 0; i < pixels; ++i)
  {
    wrong += std::isfinite(a[i]) != std::isfinite(b[i]) ? 1 : 0;
    if (std::isfinite(a[i]) && std::isfinite(b[i]))
    {
      apart.push_back(std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
    }
  }
  times.PercentWrong = 100.0 * static_cast<double>(wrong) / static_cast<double>(pixels);
  times.DepthOff = Measuring::Median(apart) / stage.VoxelSize();
  times.DepthFarOff = Measuring::Percentile(apart, 99) / stage.VoxelSize();
}

/// New isovalues of a range that was built before, as for a slider whose ends are known.
void MeasureRange(Way& way, const Stage& stage, Samples& samples)
{
  vtkTemporalCoherenceVolumeMapper* const mapper = way.Ours()->Mapper;
  mapper->SetIsomapRange(stage.Isovalue(), stage.Isovalue() + stage.ShareOfRange(FirstStep));
  for (int step = 0; step <= StepsInRange; ++step)
  {
    way.SetIsovalue(stage.Isovalue() + stage.ShareOfRange(FirstStep * (step + 0.5) / LaterSteps));
    const double time = way.Draw();
    if (step > 0 && way.Ours()->Route() == "IsomapLookup")
    {
      samples.InRange.push_back(time);
    }
  }
  mapper->SetIsomapRange(1.0, 0.0);
}

/// One view: a frame of it, new isovalues, and a cold frame.
void MeasureView(Way& way, const Stage& stage, Samples& samples)
{
  samples.NewView.push_back(way.Draw());
  const int steps = way.Ours() ? LaterSteps : LaterStepsOfPeers;
  for (int step = 0; step <= steps; ++step)
  {
    const double share = FirstStep * (steps + 1 - step) / (steps + 1);
    way.SetIsovalue(stage.Isovalue() + stage.ShareOfRange(share));
    const double time = way.Draw();
    if (step == 0)
    {
      samples.First.push_back(time);
    }
    else if (2 * step > steps)
    {
      samples.Later.push_back(time);
      samples.LookedUp += way.Ours() && way.Ours()->Route() == "IsomapLookup" ? 1 : 0;
    }
  }
  if (way.Ours())
  {
    MeasureRange(way, stage, samples);
  }
  way.SetIsovalue(stage.Isovalue());
  samples.Cold.push_back(way.DrawCold());
}

Times TimesOf(const Samples& samples)
{
  Times times;
  times.NewView = Measuring::Median(samples.NewView);
  times.SetUp = std::max(0.0, samples.First0 - times.NewView);
  times.FirstIsovalue = Measuring::Median(samples.First);
  times.LaterIsovalue = Measuring::Median(samples.Later);
  times.InRange = Measuring::Median(samples.InRange);
  times.Cold = Measuring::Median(samples.Cold);
  times.LaterLookedUp =
    100.0 * Measuring::Ratio(samples.LookedUp, static_cast<double>(samples.Later.size()));
  return times;
}

}

std::vector<Times> Measure(const Subject& subject, int rounds, bool hasWindow)
{
  Stage stage(subject.Mesh, subject.Isovalue, subject.Size, subject.From);
  std::vector<Samples> samples;
  std::vector<Times> compared;
  const std::vector<std::unique_ptr<Way>> ways = MeshPeers::All(subject, hasWindow);
  for (const std::unique_ptr<Way>& way : ways)
  {
    way->SetCamera(stage.Renderer->GetActiveCamera());
    samples.emplace_back();
    samples.back().First0 = way->Draw();
    if (way == ways.front())
    {
      way->Memory = static_cast<double>(way->Ours()->Mapper->GetStatistics()->GetMeshMemory());
    }
    compared.emplace_back();
    compared.back().PercentDrawn = way->PercentDrawn();
    Compare(*ways.front(), *way, stage, compared.back());
  }
  for (int round = 0; round < rounds; ++round)
  {
    stage.Orbit(Degrees);
    for (std::size_t i = 0; i < ways.size(); ++i)
    {
      if (round % ways[i]->SlowerBy == 0)
      {
        ways[i]->SetCamera(stage.Renderer->GetActiveCamera());
        MeasureView(*ways[i], stage, samples[i]);
      }
    }
  }
  std::vector<Times> all;
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    Times times = TimesOf(samples[i]);
    times.Who = ways[i]->Who;
    times.Remark = ways[i]->Remark;
    times.Memory = ways[i]->Memory;
    times.PercentDrawn = compared[i].PercentDrawn;
    times.PercentWrong = compared[i].PercentWrong;
    times.DepthOff = compared[i].DepthOff;
    times.DepthFarOff = compared[i].DepthFarOff;
    all.push_back(times);
  }
  return all;
}

}
