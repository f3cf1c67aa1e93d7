// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TransferSamples_h
#define TemporalCoherence_TransferSamples_h

#include "Scene/Blending.h"

#include <vector>

namespace TemporalCoherence
{

struct TransferFunctions;

/// The values at which functions are evaluated.
struct AskedValues
{
  glm::dvec2 Range; ///< of the data
  bool AreClamped;  ///< other values may occur; they are as opaque as the nearest end of the range
};

inline bool operator==(const AskedValues& a, const AskedValues& b)
{
  return a.Range == b.Range && a.AreClamped == b.AreClamped;
}

/// Sample functions at equal distances over the range that the data and the nodes have in common,
/// and slightly beyond. Nodes far from the data leave no trace. Each node in this range has a
/// sample if all nodes there fit one grid.
/// \param nodes of the functions (FindNodes)
TransferFunction SampleFunctions(
  const TransferFunctions& functions, const std::vector<double>& nodes, const AskedValues& asked);

}

#endif
