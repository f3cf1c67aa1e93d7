// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef NrrdReader_h
#define NrrdReader_h

#include "Files/Reading.h"
#include "Files/Volume.h"

#include <string>

// A header with its samples, or one that names files of them. Throws UserError.
// \param timeStep from 1, of a file of several
void ReadNrrd(
  const std::string& path, int timeStep, const ReadingProgress& progress, Volume& volume);

#endif
