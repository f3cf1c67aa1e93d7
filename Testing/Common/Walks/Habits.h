// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Habits_h
#define Testing_Habits_h

/// How many of a hundred steps make a change of each kind.
struct Habits
{
  int View = 0, Isovalues = 0, Appearance = 0, Lists = 0, Opacity = 0, Region = 0, Inputs = 0,
      Volume = 0, ImageCache = 0, Isomap = 0;

  static Habits MovingOn();      ///< mostly the view changes
  static Habits StandingStill(); ///< mostly an isovalue
  static Habits Dressing();      ///< mostly colours and lights
  static Habits Restless();      ///< several at each step
};

#endif
