// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Isovalue_h
#define Isovalue_h

#include <array>
#include <optional>
#include <string>

struct Histogram;

struct IsovalueChoice
{
  double Value = 0.0;
  std::array<double, 2> Range = { 0.0, 0.0 }; // of the volume's first component
  bool IsChosen = false;                      // from the histogram; else given
};

// The isovalue asked for, or one chosen from the histogram. Throws UserError if it meets nothing.
// \param name of the volume, for messages
IsovalueChoice ChooseIsovalue(
  const Histogram& histogram, const std::optional<double>& given, const std::string& name);

#endif
