// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Frames that fit into their time have all rays. Others have as many as fit, and no more after a
// frame that was slow.

#include "Render/RayBudget.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace TemporalCoherence;

constexpr std::int64_t Pixels = 1000000;
constexpr int Kind = 1;
constexpr double Short = 1.0 / 15, Long = 1e4, Most = 10.0;

/// A machine on which a frame takes a time that is proportional to its rays.
struct Machine
{
  double Whole = 1.0;     ///< seconds of all rays
  double Scattered = 1.8; ///< the same in a grid
  double Rest = 0.01;

  FrameStatistics Make(const RayBudget::Choice& choice, bool& isWhole) const
  {
    FrameStatistics made;
    made.Rays = Pixels;
    isWhole = choice.Distance == 1.0;
    if (!isWhole)
    {
      made.GridRays = static_cast<std::int64_t>(Pixels / (choice.Distance * choice.Distance));
      made.GridTime = this->Scattered * this->Whole * static_cast<double>(made.GridRays) / Pixels;
      made.FillTime = 0.5 * this->Rest;
    }
    const double left = choice.Until - made.GridTime - 0.5 * this->Rest;
    made.TilesTime = isWhole ? this->Whole : std::min(std::max(left, 0.0), this->Whole);
    isWhole |= made.TilesTime == this->Whole;
    made.FrameTime = made.GridTime + made.TilesTime + this->Rest;
    return made;
  }
};

TEST(RayBudget, StillFramesAreWhole)
{
  RayBudget budget;
  EXPECT_EQ(budget.Choose(Pixels, Long, Most, Kind).Distance, 1.0);
  bool isWhole = false;
  budget.Learn(Machine().Make({}, isWhole), true, Long, Kind);
  EXPECT_EQ(budget.Choose(Pixels, Long, Most, Kind).Distance, 1.0);
}

TEST(RayBudget, FramesThatFitAreWhole)
{
  RayBudget budget;
  Machine machine;
  machine.Whole = 0.03;
  bool isWhole = false;
  FrameStatistics first = machine.Make({}, isWhole);
  first.FrameTime += 2.0; // the data were set up
  budget.Learn(first, true, Long, Kind);
  for (int frame = 0; frame < 5; ++frame)
  {
    const RayBudget::Choice choice = budget.Choose(Pixels, Short, Most, Kind);
    EXPECT_EQ(choice.Distance, 1.0);
    budget.Learn(machine.Make(choice, isWhole), true, Short, Kind);
  }
  // A slow one, and then the machine is as fast as before.
  machine.Whole = 0.2;
  budget.Learn(machine.Make({}, isWhole), true, Short, Kind);
  machine.Whole = 0.03;
  int frames = 0;
  while (budget.Choose(Pixels, Short, Most, Kind).Distance > 1.0 && frames < 10)
  {
    const FrameStatistics made = machine.Make(budget.Choose(Pixels, Short, Most, Kind), isWhole);
    budget.Learn(made, isWhole, Short, Kind);
    ++frames;
  }
  EXPECT_GT(frames, 0);
  EXPECT_LT(frames, 5) << "they are whole again";
}

TEST(RayBudget, OthersFitTheTime)
{
  for (const double whole : { 0.1, 0.2, 0.5, 1.0, 1.7 })
  {
    RayBudget budget;
    Machine machine;
    machine.Whole = whole;
    bool isWhole = false;
    budget.Learn(machine.Make({}, isWhole), true, Long, Kind);
    double last = 0.0;
    for (int frame = 0; frame < 20; ++frame)
    {
      const RayBudget::Choice choice = budget.Choose(Pixels, Short, Most, Kind);
      EXPECT_GE(choice.Distance, 3.0) << whole;
      const FrameStatistics made = machine.Make(choice, isWhole);
      EXPECT_LE(made.FrameTime, Short) << whole << ", frame " << frame;
      EXPECT_GE(made.FrameTime, 0.5 * Short) << whole << ", frame " << frame;
      budget.Learn(made, isWhole, Short, Kind);
      EXPECT_TRUE(frame < 10 || std::abs(choice.Distance - last) < 0.05) << "it settles";
      last = choice.Distance;
    }
  }
}

TEST(RayBudget, StartsWithFewUntilSomethingIsKnown)
{
  EXPECT_EQ(RayBudget().Choose(Pixels, Short, Most, Kind).Distance, 6.0);
  EXPECT_EQ(RayBudget().Choose(Pixels, Short, 4.0, Kind).Distance, 4.0);
}

// A projection may take a tenth of the time of a composite picture.
TEST(RayBudget, ForgetsOtherKindsOfPictures)
{
  RayBudget budget;
  Machine machine;
  machine.Whole = 0.01;
  bool isWhole = false;
  budget.Learn(machine.Make({}, isWhole), true, Short, Kind);
  EXPECT_EQ(budget.Choose(Pixels, Short, Most, Kind).Distance, 1.0);
  EXPECT_EQ(budget.Choose(Pixels, Short, Most, Kind + 1).Distance, 6.0);
  machine.Whole = 1.0;
  budget.Learn(machine.Make({}, isWhole), true, Long, Kind + 1);
  EXPECT_GT(budget.Choose(Pixels, Short, Most, Kind + 1).Distance, 6.0);
  EXPECT_EQ(budget.Choose(Pixels, Short, Most, Kind).Distance, 6.0);
}

TEST(RayBudget, KeepsTheLargestDistance)
{
  RayBudget budget;
  Machine machine;
  machine.Whole = 100.0;
  bool isWhole = false;
  budget.Learn(machine.Make({}, isWhole), true, Long, Kind);
  EXPECT_EQ(budget.Choose(Pixels, Short, Most, Kind).Distance, Most);
  EXPECT_EQ(budget.Choose(Pixels, 0.0, 2.0, Kind).Distance, 2.0);
  EXPECT_EQ(budget.Choose(Pixels, Short, 0.5, Kind).Distance, 1.0);
}

}
