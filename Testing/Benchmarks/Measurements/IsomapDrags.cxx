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
  std::vector<double> Times;     ///< of the dragged frames
  std::vector<double> NewTimes;  ///< of cold ones that make structures of their isovalue
  std::vector<double> ColdTimes; ///< the faster of such a one and one whose structures are there
  double Traced = 0.0, ColdTraced = 0.0; ///< rays
  double BytesAPixel = 0.0;
  int Different = 0;
};

/// Cold frames, in the stage's view and in one that is all but the same.
class ColdFrames
{
public:
  explicit ColdFrames(const Stage& stage)
    : Beside(stage.Image, stage.Isovalue(), stage.Size, stage.From)
    , Cold(stage)
  {
    this->Beside.Volume->SetProperty(stage.Volume->GetProperty());
    this->Cold.Mapper->ReuseFramesOff();
    this->Cold.Mapper->IsomapOff();
  }

  /// CPU time of the stage's picture, with structures of its isovalue made anew.
  double DrawNew(Stage& stage)
  {
    this->Cold.DrawCold(stage);
    return this->Cold.CpuMs;
  }

  /// CPU time of the same once more, with the structures that are there.
  double DrawAgain(double isovalue)
  {
    this->Degrees = -this->Degrees; // never the last view
    this->Beside.Orbit(this->Degrees);
    this->Beside.SetIsovalue(isovalue);
    this->Cold.Draw(this->Beside);
    if (this->Cold.Route() != "Cold")
    {
      throw Measuring::Failure("A frame of another view is made by " + this->Cold.Route() +
        ": mend ColdFrames::DrawAgain.");
    }
    return this->Cold.CpuMs;
  }

  const Drawer& Last() const { return this->Cold; }

private:
  Stage Beside;
  Drawer Cold;
  double Degrees = 1e-3;
};

/// A new mapper goes the way, in turn with cold frames.
Steps DragOnce(Stage& stage, const Path& path)
{
  Drawer dragged(stage);
  ColdFrames cold(stage);
  stage.SetIsovalue(path.Isovalues.front());
  dragged.Draw(stage);
  // The second frame of a mapper makes room for its second picture. That belongs to no drag.
  for (const double degrees : { 1e-3, -1e-3 })
  {
    stage.Orbit(degrees);
    dragged.Draw(stage);
  }
  cold.DrawNew(stage);
  Steps steps;
  for (std::size_t i = 1; i < path.Isovalues.size(); ++i)
  {
    stage.SetIsovalue(path.Isovalues[i]);
    steps.NewTimes.push_back(cold.DrawNew(stage));
    dragged.Draw(stage);
    steps.Times.push_back(dragged.CpuMs);
    steps.Traced += static_cast<double>(dragged.Mapper->GetStatistics()->GetNumberOfTracedRays());
    steps.ColdTraced +=
      static_cast<double>(cold.Last().Mapper->GetStatistics()->GetNumberOfTracedRays());
    steps.BytesAPixel = std::max(steps.BytesAPixel, IsomapFrames::BytesAPixel(dragged, stage));
    steps.Different += AreIdentical(dragged, cold.Last()) ? 0 : 1;
    steps.ColdTimes.push_back(std::min(steps.NewTimes.back(), cold.DrawAgain(path.Isovalues[i])));
  }
  return steps;
}

void KeepFaster(std::vector<double>& times, const std::vector<double>& others)
{
  std::transform(times.begin(), times.end(), others.begin(), times.begin(),
    [](double a, double b) { return std::min(a, b); });
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

/// \param coldTimes of the same isovalues
Summary Summarize(const Path& path, const Steps& steps, const std::vector<double>& coldTimes)
{
  const std::vector<double> byCold = Quotients(steps.Times, coldTimes);
  const auto worst = std::max_element(byCold.begin(), byCold.end());
  Summary summary;
  summary.Path = path.Name;
  summary.Steps = static_cast<int>(byCold.size());
  summary.First = byCold.front();
  summary.Mean = Measuring::Mean(byCold);
  summary.NearlyWorst = Measuring::Percentile(byCold, 95);
  summary.Worst = *worst;
  summary.WorstAt = path.Isovalues[static_cast<std::size_t>(worst - byCold.begin()) + 1];
  summary.MeanOfNew = Measuring::Mean(Quotients(steps.NewTimes, coldTimes));
  summary.ColdMs = Measuring::Median(coldTimes);
  summary.PercentTraced = 100.0 * Measuring::Ratio(steps.Traced, steps.ColdTraced);
  summary.BytesAPixel = steps.BytesAPixel;
  summary.Different = steps.Different;
  return summary;
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
  const Steps first = DragOnce(stage, path), second = DragOnce(stage, path);
  stage.SetIsovalue(isovalue);

  std::vector<double> coldTimes = first.ColdTimes;
  KeepFaster(coldTimes, second.ColdTimes);
  const Summary other = Summarize(path, second, coldTimes);
  Summary summary = Summarize(path, first, coldTimes);
  summary.First = std::min(summary.First, other.First);
  summary.Mean = std::min(summary.Mean, other.Mean);
  summary.NearlyWorst = std::min(summary.NearlyWorst, other.NearlyWorst);
  summary.WorstAt = other.Worst < summary.Worst ? other.WorstAt : summary.WorstAt;
  summary.Worst = std::min(summary.Worst, other.Worst);
  summary.MeanOfNew = std::min(summary.MeanOfNew, other.MeanOfNew);
  summary.BytesAPixel = std::max(summary.BytesAPixel, other.BytesAPixel);
  summary.Different += other.Different;
  return summary;
}

}
