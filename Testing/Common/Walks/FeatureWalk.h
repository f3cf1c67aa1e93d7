// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_FeatureWalk_h
#define Testing_FeatureWalk_h

#include "Walks/ChangingScene.h"
#include "Walks/Sweep.h"

#include <map>
#include <string>

/// How often each route was taken while a feature was on.
using RoutesOfFeatures = std::map<std::string, Sweep::Routes>;

/// A scene that walks through features and steps. Each frame is compared with what its route
/// promises.
class FeatureWalk : private ChangingScene
{
public:
  explicit FeatureWalk(unsigned seed);

  /// Choose features anew, then make steps.
  void Go(const Habits& habits, int steps);

  /// Check that features that are switched off leave no trace.
  void ComeHome();

  RoutesOfFeatures Counted;
  int Stopped = 0, Lines = 0, LinesHit = 0, OtherLines = 0;

private:
  std::string Where() const;
  void Step();
  void StopSometimes();
  void ExpectSameColors();
  void ExpectSameSurfaces();
  vtkIdType CountHits() const;
  void ExpectSameLines();
  void ExpectOnePicture();

  unsigned Seed;
  ColdWitness Cold;
  int Steps = 0;
};

#endif
