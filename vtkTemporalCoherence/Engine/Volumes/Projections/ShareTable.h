// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ShareTable_h
#define TemporalCoherence_ShareTable_h

#include "Scene/Blending.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// A node: the begin of a bin of values. Kernels copy whole nodes.
struct ShareNode
{
  float Opacity, Rise; ///< Rise: to the next node
  float Share;         ///< the value as a share of the scalar range
  std::int32_t Sum;    ///< the integral from the first node to here, in quanta
};

/// Opacity times value as a share of the scalar range, integrated over values, so that a stretch of
/// a ray on which the field is linear takes two look-ups (pre-integration).
///
/// Values are counted in bins: u = (value - Low) * PerValue. Opacity is linear in bins, and
/// constant beyond the range. Sums are integers, so that their differences are exact.
struct ShareTable
{
  /// \pre the range of the transfer function is not empty
  /// \param range the values whose shares are 0 and 1
  /// \throws std::bad_alloc
  ShareTable(const TransferFunction& transfer, const glm::dvec2& range);

  double Low, PerValue;
  int Bins;                     ///< within the range
  float SharePerBin;            ///< the rise of the share
  float Quantum;                ///< of sums
  std::vector<ShareNode> Nodes; ///< one for each bin

  /// How much the function differs from a straight line.
  struct Bend
  {
    float Slopes; ///< the largest difference of slopes between bins
    float Swing;  ///< the largest difference of values
  };
  static constexpr int BlockBits = 6;
  std::vector<Bend> Bends; ///< around blocks of bins
  Bend Largest;            ///< of all bins
};

}

#endif
