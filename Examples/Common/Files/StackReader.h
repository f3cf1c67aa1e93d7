// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef StackReader_h
#define StackReader_h

#include "Files/Reading.h"
#include "Files/Volume.h"

#include <string>

// Slices: the pages of a TIFF, or the numbered pictures that one is named of, or of a folder. The
// first row of a picture is at y = 0. Throws UserError.
void ReadStack(const std::string& path, const ReadingProgress& progress, Volume& volume);

#endif
