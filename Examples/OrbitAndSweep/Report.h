// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Report_h
#define Report_h

#include "Extraction.h"
#include "Tour.h"

#include <vector>

struct Volume;

// A table on standard output: a row for each change and route.
void PrintTable(const std::vector<FrameRecord>& records);

// What samples take that are read as they are needed; of other volumes nothing.
void PrintMemory(const Volume& volume);

// What the mapper's re-use gained, and against extracting the surface anew.
void PrintGain(const std::vector<FrameRecord>& records, const Extraction& extraction);

#endif
