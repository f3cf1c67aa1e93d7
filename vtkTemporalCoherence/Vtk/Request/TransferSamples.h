// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TransferSamples_h
#define TemporalCoherence_TransferSamples_h

#include "Scene/Blending.h"

#include <vector>

namespace TemporalCoherence
{

struct TransferFunctions;

/// The values of which functions are asked.
struct AskedValues
{
  glm::dvec2 Range; ///< of the data
  bool AreClamped;  ///< there may be others, which are as opaque as the nearest end of the range
};

inline bool operator==(const AskedValues& a, const AskedValues& b)
{
  return a.Range == b.Range && a.AreClamped == b.AreClamped;
}

/// Sample functions at equal distances, over all values that are asked for and that lie between
/// their first and their last node, and somewhat beyond. Nodes far from the data leave no trace.
/// There is a sample at each node between if all of these have places in one grid.
/// \param nodes of the functions (FindNodes)
TransferFunction SampleFunctions(
  const TransferFunctions& functions, const std::vector<double>& nodes, const AskedValues& asked);

}

#endif
