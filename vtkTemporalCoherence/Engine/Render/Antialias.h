// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Antialias_h
#define TemporalCoherence_Antialias_h

#include "Render/Routes.h"
#include "Scene/Frame.h"

namespace TemporalCoherence
{

/// Make the antialiased colours of a picture: pixels at edges get the mean of several rays. All
/// other planes stay as they are.
///
/// A pixel at an edge gets 4 rays. If these differ it gets 8, and 16 if they differ much. The rays
/// have fixed places around the pixel's centre, so a picture depends on its key alone.
///
/// Where time is short (FewerRays::Elapsed), edges are made group by group. Those that are left are
/// open until the next frame.
///
/// \param light that reaches the surfaces that these rays meet; null: all of it does
/// \param picture of the task's key, whose Colors have one ray a pixel. It is unchanged unless the
///                result is true
/// \return false if the report stopped it
/// \throws std::bad_alloc
bool Antialias(FrameTask& task, SurfaceLight* light, Frame& picture);

}

#endif
