// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Runs/Run.h"

#include "Changes/Changes.h"
#include "Oracle/Oracle.h"
#include "Runs/Acts.h"
#include "Runs/Watchdog.h"

#include <vtkFloatingPointExceptions.h>

namespace Fuzz
{
namespace
{

/// Where nothing is seen or all is refused, nothing is tested for long.
void Recover(World& world, const Oracle& oracle)
{
  const bool isDull = oracle.IsLastRefused() || oracle.Last().CountHits() == 0;
  if (isDull && world.From.OneIn(oracle.IsLastRefused() ? 3 : 4))
  {
    world.MakeSane();
  }
}

void Step(World& world, Oracle& oracle, Tally& tally)
{
  int changes = world.From.OneIn(3) ? 1 + world.From.Pick(4) : 1;
  changes = world.From.OneIn(12) ? 0 : changes;
  for (int i = 0; i < changes; ++i)
  {
    Changes::MakeOne(world);
  }
  Acts::Before(world, oracle, tally);
  oracle.CheckFrame();
  Story::Tell("    ",
    oracle.IsLastRefused() ? "refused" : world.Subject->GetStatistics()->GetRouteAsString(), ", ",
    oracle.Last().IsEmpty() ? 0 : oracle.Last().CountHits(), " hits");
  Acts::After(world, oracle, tally);
  if (world.From.Pick(4) == 0)
  {
    oracle.CheckRefined();
  }
  if (!oracle.Last().IsEmpty())
  {
    Recover(world, oracle);
  }
}

}

void Run(const std::vector<std::uint8_t>& bytes, Tally& tally)
{
  constexpr int MostSteps = 400;
  Silence::Fall();
  Story::Begin();
  ++tally.Runs;
  Watchdog::Feed();
  World world(bytes);
  Oracle oracle(world, tally);
  for (int step = 0; step < MostSteps && !world.From.IsUsedUp(); ++step)
  {
    ++tally.Steps;
    Watchdog::Feed();
    Story::Tell("step ", step, ":");
    Step(world, oracle, tally);
  }
}

}
