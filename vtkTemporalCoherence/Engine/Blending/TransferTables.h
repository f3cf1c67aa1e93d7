// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TransferTables_h
#define TemporalCoherence_TransferTables_h

#include "Scene/Blending.h"

#include <array>
#include <vector>

namespace TemporalCoherence
{

/// Extinction, and the light that it emits: red, green and blue times the extinction.
using Emission = std::array<float, 4>;

/// Emission at a node, which is where a bin of values begins.
struct EmissionNode
{
  Emission Value; ///< per world distance
  Emission Rise;  ///< from here to the next node
  Emission Sum;   ///< the integral of the values from the beginning of the range to here, in bins
  float Moment;   ///< the same of extinction times value in bins
};

/// A transfer function integrated over values, so that a stretch of a ray on which the field is
/// linear takes two look-ups, however often the function bends in between (pre-integration).
///
/// Values are counted in bins: u = (value - Low) * PerValue. Between nodes emission is linear, and
/// beyond the range it is constant.
struct TransferTables
{
  /// \param mostExtinction per world distance, which stands for an opacity of 1
  /// \throws std::bad_alloc
  TransferTables(const ComponentLook& look, double mostExtinction);

  double Low, PerValue;
  int Bins;                        ///< within the range
  std::vector<EmissionNode> Nodes; ///< one for each bin
  /// The largest change of extinction from bin to bin, around blocks of bins.
  static constexpr int BlockBits = 6;
  std::vector<float> Steepness;
};

/// Gradient opacity by the magnitude of gradients, as a table: linear between entries, constant
/// beyond.
struct GradientTable
{
  /// \throws std::bad_alloc
  explicit GradientTable(const GradientOpacity& opacity);

  double Low = 0.0, PerMagnitude = 0.0; ///< entry = (magnitude - Low) * PerMagnitude
  std::vector<float> Opacities;         ///< empty: 1
};

}

#endif
