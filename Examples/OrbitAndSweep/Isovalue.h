// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Isovalue_h
#define Isovalue_h

#include <optional>
#include <vector>

class vtkImageData;

struct IsovalueChoice
{
  double Value = 0.0;
  double Range[2] = { 0.0, 0.0 }; // of the volume's first component
  bool IsChosen = false;          // from the histogram; else given
};

// The isovalue asked for, or one chosen from the histogram. Throws UserError if it meets nothing.
IsovalueChoice ChooseIsovalue(vtkImageData* image, const std::optional<double>& given);

// Isovalues around one: as a slider is dragged: 3 % of the range below to 7 % above, inside it.
std::vector<double> SweepAround(const IsovalueChoice& isovalue, int count);

#endif
