// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_TypicalFrames_h
#define Benchmarks_TypicalFrames_h

#include "Report.h"
#include "Stage.h"

#include <string>
#include <vector>

/// The frames that a user waits for, in one go: a moved camera, which is cold, and a new isovalue.
namespace TypicalFrames
{

/// Medians in milliseconds.
struct Times
{
  double Cold = 0.0;      ///< an orbit of 2 degrees a frame
  double ColdShade = 0.0; ///< of that, shading
  double First = 0.0;     ///< the first new isovalue in a view, which builds a band
  double Lookup = 0.0;    ///< one that is looked up
};

/// The stage comes back to its first view and isovalue.
Times Measure(Stage& stage, int frames);

/// Times beside those of a reference: each, and by how much the reference takes longer.
/// \param first the first columns of the table
MarkdownTable BeginComparison(const std::vector<std::string>& first);
void PrintComparison(const MarkdownTable& table, const std::vector<std::string>& first,
  const Times& reference, const Times& times);

/// Add all times to an open object.
void AddTo(JsonWriter& json, const Times& times);

}

#endif
