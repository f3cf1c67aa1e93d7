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

/// Emission in a bin of values: one line of the caches, in rows of four numbers.
struct alignas(64) EmissionBin
{
  Emission Value; ///< where the bin begins, per world distance
  Emission Rise;  ///< from there to its end
  Emission Sum;   ///< the integral from the beginning of the range to the bin, in bins
  float Moment;   ///< the same of extinction times value in bins
  float Boost;    ///< Value times this is emitted at the very beginning, where a peak may be
};

/// A transfer function integrated over values, so that a stretch of a ray on which the field is
/// linear takes two look-ups, however often the function bends in between (pre-integration).
///
/// Values are counted in bins: u = (value - Low) * PerValue. In a bin emission is linear, and
/// beyond the range it is constant.
struct TransferTables
{
  /// \param mostExtinction per world distance, which stands for an opacity of 1
  /// \throws std::bad_alloc
  TransferTables(const ComponentLook& look, double mostExtinction);

  double Low, PerValue;
  int Bins;                     ///< within the range
  std::vector<EmissionBin> All; ///< and one for what lies above the range
  /// Where values differ less, in bins, the difference of their sums has too few digits.
  float Closest;
  float MostCounted; ///< extinction above this is opaque at once, and Sum does not count all of it
  /// The largest change of extinction from bin to bin, for blocks of bins and as many blocks on
  /// each side as the level tells, 1, 2, 4 and so on: [level * blocks + block].
  static constexpr int BlockBits = 6, Levels = 6;
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
