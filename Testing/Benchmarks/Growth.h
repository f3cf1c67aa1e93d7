// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_Growth_h
#define Benchmarks_Growth_h

#include "Report.h"
#include "Stage.h"

#include <functional>
#include <string>
#include <vector>

/// How times grow with the data: the same object with more and more samples.
namespace Growth
{

/// What is measured of every size.
struct Quantity
{
  std::string Column; ///< of the table; none: only in JSON
  std::string Name;   ///< in JSON
};

/// Measure the four spheres and Marschner and Lobb's signal at 128^3 samples and twice as many in
/// each direction until the largest; print a table of medians in ms, and add "growth" to the
/// report. \param measure gives the quantities in their order \throws Measuring::Failure if the
/// largest is too small
void Report(const std::vector<Quantity>& quantities, int pixels, int largest,
  const std::function<std::vector<double>(Stage&)>& measure, JsonWriter& json);

}

#endif
