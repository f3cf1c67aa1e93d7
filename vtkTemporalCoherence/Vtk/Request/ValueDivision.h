// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ValueDivision_h
#define TemporalCoherence_ValueDivision_h

#include "Request/AppearanceFromVolume.h"

#include <cstddef>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// The division of values into intervals of a ValueTable.
struct ValueDivision
{
  std::vector<double> Bounds; ///< as ValueTable::Bounds
  std::size_t InSegment = 1;  ///< intervals
  bool AreSteps = false;      ///< an interval has one colour
};

/// Divide values as the table or the colour function of looks does.
/// \param error receives the mistake and its remedy
/// \return false on error
bool DivideByColor(const SurfaceLooks& looks, ValueDivision& found, std::string& error);

/// Divide values as the opacities of the table, or the opacity function, of looks do.
/// \param error receives the mistake and its remedy
/// \return false on error
bool DivideByOpacity(const SurfaceLooks& looks, ValueDivision& found, std::string& error);

}

#endif
