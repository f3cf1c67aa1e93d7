// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CacheFrames.h"

#include "Measuring.h"
#include "Report.h"

#include <algorithm>
#include <deque>

namespace CacheFrames
{
namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;

/// Farther, a zoom would enter the volume and a pan would leave it.
constexpr int LongestWayOut = 30;

/// +1 on the way out and -1 on the way back, in turn.
int DirectionOf(int frame, int frames)
{
  const int way = std::clamp(frames / 2, 1, LongestWayOut);
  return frame / way % 2 == 0 ? 1 : -1;
}

Measures Measure(Mapper* mapper, double frameMs, double differentPixels)
{
  const auto rays = static_cast<double>(mapper->GetStatistics()->GetNumberOfRays());
  const auto samples = static_cast<double>(mapper->GetStatistics()->GetNumberOfFieldSamples());
  const auto percentOfRays = [rays](vtkIdType some)
  { return 100.0 * Measuring::Ratio(static_cast<double>(some), rays); };
  Measures m{};
  m[FrameMs] = frameMs;
  m[QueryMs] = 1e3 * mapper->GetStatistics()->GetQueryTime();
  m[TraceMs] = 1e3 * mapper->GetStatistics()->GetTraceTime();
  m[ShadeMs] = 1e3 * mapper->GetStatistics()->GetShadeTime();
  m[DefiniteHits] = percentOfRays(mapper->GetStatistics()->GetNumberOfDefiniteHits());
  m[DefiniteMisses] = percentOfRays(mapper->GetStatistics()->GetNumberOfDefiniteMisses());
  m[PossibleHits] = percentOfRays(mapper->GetStatistics()->GetNumberOfPossibleHits());
  m[SamplesPerRay] = Measuring::Ratio(samples, rays);
  m[SamplesPerTracedRay] = Measuring::Ratio(
    samples, static_cast<double>(mapper->GetStatistics()->GetNumberOfTracedRays()));
  m[DifferentPixels] = differentPixels;
  return m;
}

/// A variant at work.
struct Runner
{
  Runner(const Stage& stage, const Motion& motion, const Variant& variant)
    : Draws(stage)
    , Name(variant.Name)
  {
    this->Draws.Mapper->RefineWhenStillOff();
    this->Draws.Mapper->SetSpaceLeaping(motion.SpaceLeaping);
    variant.Set(this->Draws.Mapper);
    this->Draws.Draw(stage);
  }

  std::vector<double> AllOf(Quantity quantity) const
  {
    std::vector<double> values;
    for (const Measures& frame : this->Frames)
    {
      values.push_back(frame[quantity]);
    }
    return values;
  }

  Summary Summarise() const
  {
    Summary summary;
    summary.Variant = this->Name;
    for (std::size_t i = 0; i < NumberOfQuantities; ++i)
    {
      summary.Medians[i] = Measuring::Median(this->AllOf(static_cast<Quantity>(i)));
    }
    summary.WorstDifferentPixels = Measuring::Worst(this->AllOf(DifferentPixels));
    summary.FramesFromCache =
      100.0 * Measuring::Ratio(this->NumberFromCache, static_cast<double>(this->Frames.size()));
    return summary;
  }

  Drawer Draws;
  std::string Name;
  double LastMs = 0.0;
  std::vector<Measures> Frames;
  int NumberFromCache = 0;
};

}

const char* NameOf(Quantity quantity)
{
  static constexpr std::array<const char*, NumberOfQuantities> names = { "frameMs", "queryMs",
    "traceMs", "shadeMs", "definiteHitsPercent", "definiteMissesPercent", "possibleHitsPercent",
    "samplesPerRay", "samplesPerTracedRay", "differentPixelsPercent" };
  return names[quantity];
}

const std::vector<Variant>& AllVariants()
{
  static const std::vector<Variant> variants = {
    { "cold", [](Mapper* m) { m->ReuseFramesOff(); } },
    { "EXACT", [](Mapper* m) { m->SetReuseAccuracyToExact(); } },
    { "PAPER", [](Mapper* m) { m->SetReuseAccuracyToPaper(); } },
    { "PAPER, interpolated",
      [](Mapper* m)
      {
        m->SetReuseAccuracyToPaper();
        m->SetImageCacheShadingToInterpolate();
      } },
  };
  return variants;
}

Motion Orbit(double degrees)
{
  return { "orbit " + Plain(degrees), [degrees](Stage& stage, int, int) { stage.Orbit(degrees); } };
}

std::vector<Motion> AllMotions()
{
  const auto zoom = [](Stage& stage, int frame, int frames)
  { stage.Approach(DirectionOf(frame, frames) > 0 ? 1.02 : 1.0 / 1.02); };
  const auto pan = [](Stage& stage, int frame, int frames)
  { stage.Pan(0.01 * DirectionOf(frame, frames)); };
  Motion plainOrbit = Orbit(2.0);
  plainOrbit.Name += " plain";
  plainOrbit.SpaceLeaping = false;
  return { Orbit(0.5), Orbit(1.0), Orbit(2.0), Orbit(5.0), { "zoom", zoom }, { "pan", pan },
    plainOrbit };
}

std::vector<Summary> Run(
  Stage& stage, const Motion& motion, const std::vector<Variant>& variants, int frames)
{
  stage.ResetView();
  std::deque<Runner> runners;
  for (const Variant& variant : variants)
  {
    runners.emplace_back(stage, motion, variant);
  }
  for (int frame = 0; frame < frames; ++frame)
  {
    motion.Move(stage, frame, frames);
    // Each begins in turn, so that none always finds the samples in the processor's cache.
    for (std::size_t i = 0; i < runners.size(); ++i)
    {
      Runner& runner = runners[(i + static_cast<std::size_t>(frame)) % runners.size()];
      runner.LastMs = runner.Draws.Draw(stage);
    }
    for (Runner& runner : runners)
    {
      const double different = PercentDifferent(runner.Draws, runners.front().Draws, stage);
      runner.Frames.push_back(Measure(runner.Draws.Mapper, runner.LastMs, different));
      runner.NumberFromCache += runner.Draws.Route() == "ImageCache" ? 1 : 0;
    }
  }
  std::vector<Summary> summaries;
  for (const Runner& runner : runners)
  {
    summaries.push_back(runner.Summarise());
  }
  return summaries;
}

}
