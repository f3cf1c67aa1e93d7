// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsomapDrags.h"

#include "IsomapFrames.h"
#include "Measuring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>

namespace IsomapDrags
{
namespace
{

/// Drags go between these shares of the range of values; beyond them little is to be seen.
constexpr double Low = 0.05, High = 0.95;

/// What was measured of each step; CPU times in milliseconds.
struct Steps
{
  std::vector<double> Times;    ///< of the dragged frames
  std::vector<double> NewTimes; ///< of cold ones that make structures of their isovalue
  std::vector<double> ColdTimes;
  double Traced = 0.0, ColdTraced = 0.0; ///< rays
  double BytesAPixel = 0.0;
  int Different = 0;
};

/// Cold frames of isovalues whose structures are there, beside a stage and all but in its view.
class ColdFrames
{
public:
  explicit ColdFrames(const Stage& stage)
    : Beside(stage.Image, stage.Isovalue(), stage.Size, stage.From)
    , Cold(this->Beside)
  {
    this->Cold.Mapper->ImageCacheOff();
    this->Cold.Mapper->IsomapOff();
  }

  /// CPU time of a frame in a view that is never the last one.
  double Draw(double isovalue)
  {
    this->Degrees = -this->Degrees;
    this->Beside.Orbit(this->Degrees);
    this->Beside.SetIsovalue(isovalue);
    this->Cold.Draw(this->Beside);
    return this->Cold.CpuMs;
  }

private:
  Stage Beside;
  Drawer Cold;
  double Degrees = 1e-3;
};

/// Two mappers go the same way, and the faster counts: the slowest frame is to be a frame that
/// takes long, not one that something else disturbed. Of the cold frames the fastest of three
/// counts. All are drawn in turn.
Steps Drag(Stage& stage, const Path& path)
{
  std::array<Drawer, 2> drawers = { Drawer(stage), Drawer(stage) };
  Drawer fresh(stage);
  ColdFrames cold(stage);
  stage.SetIsovalue(path.Isovalues.front());
  for (Drawer* drawer : { &drawers[0], &drawers[1], &fresh })
  {
    drawer->Draw(stage);
  }
  Steps steps;
  for (std::size_t i = 1; i < path.Isovalues.size(); ++i)
  {
    const double isovalue = path.Isovalues[i];
    stage.SetIsovalue(isovalue);
    fresh.DrawCold(stage);
    drawers[0].Draw(stage);
    const double first = cold.Draw(isovalue);
    drawers[1].Draw(stage);
    const double second = cold.Draw(isovalue);
    steps.Times.push_back(std::min(drawers[0].CpuMs, drawers[1].CpuMs));
    steps.NewTimes.push_back(fresh.CpuMs);
    steps.ColdTimes.push_back(std::min({ fresh.CpuMs, first, second }));
    steps.Traced += static_cast<double>(drawers[0].Mapper->GetNumberOfTracedRays());
    steps.ColdTraced += static_cast<double>(fresh.Mapper->GetNumberOfTracedRays());
    steps.BytesAPixel = std::max(steps.BytesAPixel, IsomapFrames::BytesAPixel(drawers[0], stage));
    steps.Different += AreIdentical(drawers[0], fresh) ? 0 : 1;
  }
  return steps;
}

std::vector<double> Quotients(
  const std::vector<double>& numerators, const std::vector<double>& denominators)
{
  std::vector<double> quotients;
  for (std::size_t i = 0; i < numerators.size(); ++i)
  {
    quotients.push_back(Measuring::Ratio(numerators[i], denominators[i]));
  }
  return quotients;
}

/// A share that goes on and on, back and forth between Low and High.
double Reflected(double share)
{
  constexpr double span = High - Low;
  const double along = std::fmod(share - Low, 2.0 * span);
  return Low + (along < span ? along : 2.0 * span - along);
}

}

std::vector<Path> AllPaths(const Stage& stage, int steps)
{
  constexpr int quarter = 6; // steps up, as many down, and the same below
  constexpr double smallStep = 0.004;
  const double begin = (stage.Isovalue() - stage.IsovalueAt(0.0)) / stage.ShareOfRange(1.0);
  std::vector<Path> paths = { { "steps of 0.2 %", {} }, { "steps of 1 %", {} },
    { "steps of 5 %", {} }, { "back and forth", {} }, { "anywhere", {} } };
  for (Path& path : paths)
  {
    path.Isovalues.push_back(stage.Isovalue());
  }
  std::mt19937 random(4);
  for (int i = 1; i <= steps; ++i)
  {
    const int at = i % (4 * quarter);
    const int around = at <= quarter ? at : at <= 3 * quarter ? 2 * quarter - at : at - 4 * quarter;
    // Not by std::uniform_real_distribution, which libraries make in different ways.
    const double anywhere = static_cast<double>(random()) / static_cast<double>(random.max());
    const std::array<double, 5> shares = { Reflected(begin + 0.002 * i),
      Reflected(begin + 0.01 * i), Reflected(begin + 0.05 * i), begin + smallStep * around,
      Low + (High - Low) * anywhere };
    for (std::size_t p = 0; p < paths.size(); ++p)
    {
      paths[p].Isovalues.push_back(stage.IsovalueAt(shares[p]));
    }
  }
  return paths;
}

Summary Run(Stage& stage, const Path& path)
{
  const double isovalue = stage.Isovalue();
  const Steps steps = Drag(stage, path);
  stage.SetIsovalue(isovalue);

  const std::vector<double> byCold = Quotients(steps.Times, steps.ColdTimes);
  const auto worst = std::max_element(byCold.begin(), byCold.end());
  Summary summary;
  summary.Path = path.Name;
  summary.Steps = static_cast<int>(byCold.size());
  summary.First = byCold.front();
  summary.Mean = Measuring::Mean(byCold);
  summary.NearlyWorst = Measuring::Percentile(byCold, 95);
  summary.Worst = *worst;
  summary.WorstAt = path.Isovalues[static_cast<std::size_t>(worst - byCold.begin()) + 1];
  summary.MeanOfNew = Measuring::Mean(Quotients(steps.NewTimes, steps.ColdTimes));
  summary.ColdMs = Measuring::Median(steps.ColdTimes);
  summary.PercentTraced = 100.0 * Measuring::Ratio(steps.Traced, steps.ColdTraced);
  summary.BytesAPixel = steps.BytesAPixel;
  summary.Different = steps.Different;
  return summary;
}

}
