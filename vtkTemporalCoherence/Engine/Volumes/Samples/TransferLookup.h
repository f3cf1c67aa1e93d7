// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TransferLookup_h
#define TemporalCoherence_TransferLookup_h

#include "Scene/Blending.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>

namespace TemporalCoherence
{

/// The value of a node.
inline double ValueAt(const TransferFunction& transfer, std::size_t node)
{
  return glm::mix(transfer.Range.x, transfer.Range.y,
    static_cast<double>(node) / static_cast<double>(transfer.Nodes.size() - 1));
}

/// Colour and opacity of a value that is not NaN.
inline glm::dvec4 LookUp(const TransferFunction& transfer, double value)
{
  const std::size_t last = transfer.Nodes.size() - 1;
  const double width = transfer.Range.y - transfer.Range.x;
  const double share =
    width > 0.0 ? (value - transfer.Range.x) / width : (value < transfer.Range.x ? 0.0 : 1.0);
  const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(last);
  const std::size_t node = std::min(static_cast<std::size_t>(at), last - 1);
  return glm::mix(transfer.Nodes[node], transfer.Nodes[node + 1], at - static_cast<double>(node));
}

}

#endif
