// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_IsomapWindow_h
#define Benchmarks_IsomapWindow_h

#include "Stage.h"

/// A threshold that is dragged in a render window, beside what any picture costs there.
namespace IsomapWindow
{

/// Medians in milliseconds, from the call of Render() until the window has drawn.
struct Times
{
  double Lookup = 0.0;  ///< a new isovalue, from the isomap
  double Present = 0.0; ///< of that, the mapper's own part of showing it
  double Reshade = 0.0; ///< new colours, which the same mapper shows
  double Picture = 0.0; ///< any other picture of this size each time, by a vtkImageActor
};

/// \throws Measuring::Failure if a window needs a display and there is none
Times Measure(Stage& stage, int frames);

}

#endif
