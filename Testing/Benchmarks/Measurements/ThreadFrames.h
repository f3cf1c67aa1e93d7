// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_ThreadFrames_h
#define Benchmarks_ThreadFrames_h

#include "Report.h"
#include "Stage.h"
#include "TypicalFrames.h"

#include <string>
#include <vector>

/// The same frames with more and more threads.
namespace ThreadFrames
{

struct Times
{
  std::string Backend; ///< of vtkSMPTools
  int Threads = 0;
  TypicalFrames::Times Frames;
};

/// With one thread, which does all itself; with 2, 4 ... and all threads of the machine, by VTK's
/// backend of plain threads, the only one that starts as many as it is told; and last by the
/// backend that is used otherwise, if it is another one.
std::vector<Times> Measure(Stage& stage, int frames);

/// Add a list of all to an open object.
void AddTo(JsonWriter& json, const std::vector<Times>& all);

}

#endif
