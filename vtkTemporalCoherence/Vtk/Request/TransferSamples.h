// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TransferSamples_h
#define TemporalCoherence_TransferSamples_h

#include "Scene/Blending.h"

#include <vector>

namespace TemporalCoherence
{

struct TransferFunctions;

/// Sample functions at equal distances, from below their first node to above their last. There is
/// a sample at each node if all nodes have places in one grid.
/// \param nodes of the functions (FindNodes)
TransferFunction SampleFunctions(
  const TransferFunctions& functions, const std::vector<double>& nodes);

}

#endif
