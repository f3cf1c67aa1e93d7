// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ValuesInBand_h
#define TemporalCoherence_ValuesInBand_h

#include "Scene/Surfaces.h"

#include <limits>

namespace TemporalCoherence
{

/// True if the values [least, most] overlap a band. A band contains Low, but not High, unless High
/// is infinity.
inline bool ReachInto(const ValueBand& band, double least, double most)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return most >= band.Low && (least < band.High || band.High == infinity);
}

}

#endif
