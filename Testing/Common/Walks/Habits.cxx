// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Walks/Habits.h"

Habits Habits::MovingOn()
{
  Habits habits;
  habits.View = 85;
  habits.Isovalues = 4;
  habits.Appearance = 8;
  habits.Lists = 2;
  habits.Opacity = 3;
  habits.Region = 3;
  habits.Inputs = 3;
  habits.Volume = 2;
  habits.ImageCache = 4;
  return habits;
}

Habits Habits::StandingStill()
{
  Habits habits;
  habits.View = 6;
  habits.Isovalues = 85;
  habits.Appearance = 8;
  habits.Lists = 2;
  habits.Opacity = 2;
  habits.Region = 2;
  habits.Inputs = 2;
  habits.Volume = 2;
  habits.ImageCache = 1;
  habits.Isomap = 3;
  return habits;
}

Habits Habits::Dressing()
{
  Habits habits;
  habits.View = 4;
  habits.Isovalues = 6;
  habits.Appearance = 80;
  habits.Lists = 1;
  habits.Opacity = 4;
  habits.Region = 2;
  habits.Inputs = 1;
  habits.Volume = 1;
  habits.ImageCache = 1;
  habits.Isomap = 1;
  return habits;
}

Habits Habits::Restless()
{
  Habits habits;
  habits.View = 40;
  habits.Isovalues = 40;
  habits.Appearance = 20;
  habits.Lists = 15;
  habits.Opacity = 20;
  habits.Region = 25;
  habits.Inputs = 25;
  habits.Volume = 15;
  habits.ImageCache = 15;
  habits.Isomap = 10;
  return habits;
}
