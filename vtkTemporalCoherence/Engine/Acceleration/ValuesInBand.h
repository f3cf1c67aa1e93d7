// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ValuesInBand_h
#define TemporalCoherence_ValuesInBand_h

#include "Scene/Surfaces.h"

#include <limits>

namespace TemporalCoherence
{

/// True if values from the least to the most reach into a band. A band holds its Low, and not its
/// High, but for infinity: nothing is beyond that.
inline bool ReachInto(const ValueBand& band, double least, double most)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return most >= band.Low && (least < band.High || band.High == infinity);
}

}

#endif
