// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Trial_h
#define Trial_h

#include "Files/Reading.h"
#include "Files/Volume.h"
#include "Program/VolumeSource.h"

#include <optional>

// VTK's readers believe what files say: some files end them, some never end, and some take all
// memory. So a process of its own reads a file first, within limits of time and memory. What
// happens to it there is one sentence here, and the program goes on.
//
// That process is a copy of this one, as it was when BeginTrials() was called: before there were
// threads or a display. It makes a copy of itself for each file, which takes a millisecond.

// Is called at the beginning of main(). Does nothing where there are no such copies (Windows):
// files are then read without a trial.
void BeginTrials();

// Reads a file once, elsewhere. Throws UserError if that did not go well, or if it was stopped. A
// file that did well is not tried again until it is another one.
// Returns the volume where reading took long enough to be noticed twice; else it is to be read
// here.
std::optional<Volume> TryReading(const VolumeSource& source, const ReadingProgress& progress);

#endif
