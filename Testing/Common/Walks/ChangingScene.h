// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_ChangingScene_h
#define Testing_ChangingScene_h

#include "Checks/EventCounter.h"
#include "Walks/Habits.h"
#include "Walks/ManyInputs.h"

#include <set>
#include <string>
#include <vector>

/// A scene whose features are switched on and off, and which changes step by step. The same seed
/// gives the same scene.
class ChangingScene
{
public:
  /// \param size of the smaller pictures, in pixels; others are up to 60 pixels larger
  ChangingScene(unsigned seed, int size);

  /// Choose features anew: about every other one is on.
  void Arrange();

  /// Make the changes of one step.
  void ChangeSome(const Habits& habits);

  /// The names of the features that are on.
  std::set<std::string> Features() const;

  Scene Shown{ nullptr, { 0.0 } };
  RandomViews Views;
  ManyInputs Inputs;

private:
  void MakeOneOf(std::size_t kind);

  EventCounter Warnings; // limits of memory are reached on purpose
  std::vector<std::vector<Change>> Kinds;
  vtkSmartPointer<vtkCamera> OtherCamera;
};

#endif
