// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Sweep_h
#define Testing_Sweep_h

#include "Scenes/Subject.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

/// Sweeps of isovalues in a still view, to test isomaps and hints.
namespace Sweep
{

/// A way to look at a volume.
/// \pre the scene has one
struct Placing
{
  std::string Name;
  std::function<void(Scene&)> SetCamera;
};

/// From outside in both projections, along an axis, from inside, and clipped by the near plane.
std::vector<Placing> AllPlacings();

/// Small volumes of all kinds of samples: integers and others, smooth or not, finite or not,
/// constant, thin, oriented, of several components.
std::vector<Subject> AllFields();

/// The finite samples of the component drawn.
std::vector<double> FiniteSamplesOf(const Subject& subject);

/// Isovalues from below the samples to above them, in equal steps. Integers for integer samples, as
/// these are met exactly.
std::vector<double> Up(const Subject& subject, int steps);

/// Isovalues anywhere: samples and their next neighbours, small steps, values in and far beyond the
/// range.
std::vector<double> Jumps(const Subject& subject, int steps, unsigned seed);

/// How often each route was taken.
using Routes = std::map<std::string, int>;

/// Print them in a line.
void Tell(const std::string& what, const Routes& routes);

/// Expect that all frames after the cold one took one of some routes or were redisplayed, and that
/// each of these routes was taken at least once.
void ExpectOnly(
  const std::vector<std::string>& allowed, const Routes& routes, const std::string& what);

/// Show isovalues one after the other and expect the bytes of a cold frame each time.
Routes ExpectCold(Scene& scene, const std::vector<double>& isovalues, int width, int height,
  const std::string& what);

/// The same for lists of isovalues.
Routes ExpectCold(Scene& scene, const std::vector<std::vector<double>>& lists, int width,
  int height, const std::string& what);

}

#endif
