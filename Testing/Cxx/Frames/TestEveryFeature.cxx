// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Whatever features are on, together and one after the other: every frame is what its route
// promises, whichever steps led there.

#include "Checks/Expect.h"
#include "Walks/FeatureWalk.h"

#include <vtkSMPTools.h>

#include <cstdlib>

namespace
{

/// Each feature has met each route that it allows.
void ExpectEnough(RoutesOfFeatures& counted)
{
  for (auto& [feature, routes] : counted)
  {
    Sweep::Tell(feature, routes);
    const bool hasCache = feature != "exact";
    Expect(routes["Cold"] >= 20 && routes["Redisplay"] >= 5 && routes["Reshade"] >= 2 &&
        (!hasCache || routes["ImageCache"] >= 10),
      feature + ": too few frames of some route");
    Expect(routes["IsomapBuild"] + routes["IsomapLookup"] >= 2, feature + ": too few isomaps");
  }
  Expect(counted.size() >= 19, "every feature is seen");
}

/// A sum over several walks.
struct Sum
{
  void Add(const FeatureWalk& walk)
  {
    for (const auto& [feature, routes] : walk.Counted)
    {
      for (const auto& [route, count] : routes)
      {
        this->Counted[feature][route] += count;
      }
    }
    this->Stopped += walk.Stopped;
    this->Lines += walk.Lines;
    this->LinesHit += walk.LinesHit;
    this->OtherLines += walk.OtherLines;
  }

  void Judge()
  {
    ExpectEnough(this->Counted);
    Expect(this->Stopped >= 30, "frames are stopped");
    std::cout << this->Stopped << " frames stopped; " << this->OtherLines << " of " << this->Lines
              << " lines differ, " << this->LinesHit << " met a surface\n";
    // A grazing line may meet a surface more or less.
    Expect(this->OtherLines <= this->Lines / 1000 && this->LinesHit > 200,
      "lines meet what pixels show");
  }

  RoutesOfFeatures Counted;
  int Stopped = 0, Lines = 0, LinesHit = 0, OtherLines = 0;
};

}

int TestEveryFeature(int argc, char* argv[])
{
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(2);
  Sum sum;
  // Other seeds may be asked for: the first one, and how many.
  const unsigned first = argc > 2 ? static_cast<unsigned>(std::atoi(argv[1])) : 1u;
  const unsigned many = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 6u;
  for (unsigned seed = first; seed < first + many; ++seed)
  {
    FeatureWalk walk(seed);
    for (int round = 0; round < 6; ++round)
    {
      walk.Go(Habits::MovingOn(), 30);
      walk.Go(Habits::StandingStill(), 30);
      walk.Go(Habits::Dressing(), 10);
      walk.Go(Habits::Restless(), 20);
    }
    walk.ComeHome();
    sum.Add(walk);
  }
  sum.Judge();
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(backend.c_str());
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
