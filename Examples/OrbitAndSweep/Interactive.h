// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Interactive_h
#define Interactive_h

struct IsovalueChoice;
struct Options;
class Scene;

// A window: the mouse turns the volume, a slider sets the isovalue, a line tells what each frame
// took. Returns when the window is closed, or with a screenshot at once. Throws UserError.
void RunInteractive(Scene& scene, const IsovalueChoice& isovalue, const Options& options);

#endif
