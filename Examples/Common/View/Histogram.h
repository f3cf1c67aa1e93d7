// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Histogram_h
#define Histogram_h

#include <array>
#include <vector>

struct Volume;

// How many samples of a component of a volume, by default the first, lie around each of evenly
// spaced values: those of the first bin around Range[0], those of the last around Range[1].
struct Histogram
{
  std::array<double, 2> Range = { 0.0, 0.0 };               // least and greatest finite value
  std::vector<double> Bins = std::vector<double>(256, 0.0); // fewer for few whole numbers
};

// Of the array that is drawn; component -1 is the length of its vectors. Throws UserError if all
// samples are the same.
Histogram CountSamples(const Volume& volume, int component = 0);

#endif
