// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_RandomChanges_h
#define Testing_RandomChanges_h

#include "Truth/ColdWitness.h"
#include "Walks/RandomViews.h"
#include "Walks/Sweep.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

/// A change. A change of the data invalidates all cached pictures.
struct Change
{
  bool IsOfData;
  std::function<void()> Make;
};

/// Samples, transform, interpolation, mode, isovalues, colours, lights.
/// \param image that of the scene, of Volumes::Waves()
std::vector<Change> ChangesOfScene(Scene& scene, vtkImageData* image, RandomViews& views);

/// Small steps, jumps, values outside the samples, one of several moved, added or left out.
std::vector<Change> ChangesOfIsovalues(Scene& scene, RandomViews& views);

/// Camera and size of the picture; among them no change at all.
std::vector<Change> ChangesOfView(Scene& scene, RandomViews& views);

/// Settings of the image cache.
std::vector<Change> ChangesOfImageCache(Scene& scene, RandomViews& views);

/// Settings of the isomap.
std::vector<Change> ChangesOfIsomap(Scene& scene, RandomViews& views);

/// Hide other cells and points, or none. Ghost arrays may be removed.
std::vector<Change> ChangesOfGhosts(vtkImageData* image, RandomViews& views);

/// Compare a frame with what its route, accuracy and tolerance promise.
void ExpectPromise(Scene& scene, ColdWitness& cold, const std::string& what);

/// Check that a repeated view ends in the cold picture.
/// \pre the witness has drawn it
void ExpectRefined(Scene& scene, RandomViews& views, ColdWitness& cold, const std::string& what);

/// Changes of one kind, and how many of twelve steps make one of them.
using KindOfChange = std::pair<int, std::vector<Change>>;

/// How many of twelve steps make a change of each kind.
struct Twelfths
{
  int View = 8, Scene = 1, Isovalues = 5, ImageCache = 1, Isomap = 1;
};

/// Of everything but what hides cells. The arguments are those of ChangesOfScene().
std::vector<KindOfChange> KindsOfChange(
  Scene& scene, vtkImageData* image, RandomViews& views, const Twelfths& often = {});

/// Make changes in random order, at most one of each kind at a time, and hold every frame against
/// what its route promises.
/// \return how often each route was taken
Sweep::Routes Wander(Scene& scene, RandomViews& views, const std::vector<KindOfChange>& kinds,
  const std::string& name, int steps);

#endif
