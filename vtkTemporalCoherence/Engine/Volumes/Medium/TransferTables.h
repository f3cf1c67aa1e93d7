// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TransferTables_h
#define TemporalCoherence_TransferTables_h

#include "Scene/Blending.h"

#include <algorithm>
#include <array>
#include <cstddef>
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
  float Moment;   ///< the integral of extinction times the value in bins
  /// The integrals of emitted red, green and blue times Sum[0], which tell the order of colours.
  std::array<float, 3> Order;
};

/// Opaque values in a bin.
struct OpaqueBin
{
  float Boost; ///< factor of Value for stretches that stay at the begin of the bin, a peak
  float Walls; ///< number of opaque ranges before the bin
};

/// A transfer function integrated over values, so that a stretch of a ray on which the field is
/// linear takes two look-ups, however often the function bends in between (pre-integration).
///
/// Values are counted in bins: u = (value - Low) * PerValue. In a bin emission is linear, and
/// beyond the range it is constant.
struct TransferTables
{
  /// \param mostExtinction stands for an opacity of 1, per world distance
  /// \throws std::bad_alloc
  TransferTables(const ComponentLook& look, double mostExtinction);

  /// Emission at a value in bins.
  /// \pre the value is not NaN
  Emission At(float value) const
  {
    const int bin = this->BinAt(value);
    const EmissionBin& in = this->All[static_cast<std::size_t>(std::max(bin, 0))];
    const float share = bin < 0 || bin >= this->Bins ? 0.0f : value - static_cast<float>(bin);
    Emission at;
    for (std::size_t i = 0; i < at.size(); ++i)
    {
      at[i] = in.Value[i] + share * in.Rise[i];
    }
    return at;
  }

  /// Upper bound of the deviation of emission from the chord between two values.
  float OffLine(float low, float high) const
  {
    // A single kink deviates most from the chord at its middle; deviations of several kinks add up
    // at most.
    const auto first = static_cast<std::size_t>(this->BinAt(low) + 1);
    const auto last = static_cast<std::size_t>(this->BinAt(high) + 1);
    const double bends = this->Bends[last] - this->Bends[first];
    // Values below the range look like the begin of the first bin.
    const double peaks = this->Peaks[std::max<std::size_t>(last, 1)] -
      this->Peaks[std::max<std::size_t>(first, 1) - 1];
    return static_cast<float>(0.25 * static_cast<double>(high - low) * bends + peaks);
  }

  /// True if a bin, or its begin, holds an opaque value.
  bool IsOpaqueIn(std::size_t bin) const
  {
    return this->Opaque[bin].Boost != 1.0f || this->All[bin].Value[0] > this->MostCounted;
  }

  double Low, PerValue;
  int Bins;                      ///< within the range
  std::vector<EmissionBin> All;  ///< and one for values above the range
  std::vector<OpaqueBin> Opaque; ///< of the same bins
  float Beyond; ///< distances from the range up to this, in bins, may be rounding errors
  /// The difference of sums has too few digits for values closer than this, in bins.
  float Closest;
  float LeastOrdered;             ///< Order has too few digits for smaller differences of Sum[0]
  float MostExtinction;           ///< stands for an opacity of 1
  bool AreOpaqueAnywhere = false; ///< true if some value is opaque
  float MostCounted; ///< larger extinctions count as opaque; Sum need not count all of them
  /// The largest change of emission from bin to bin, over a block of bins and 2^level blocks on
  /// each side: [level * blocks + block]. The last level covers all blocks.
  static constexpr int BlockBits = 6, Levels = 6;
  std::vector<float> Steepness;

private:
  /// The bin of a value: -1 below the range, Bins above.
  int BinAt(float value) const
  {
    const float last = static_cast<float>(this->Bins);
    return value < 0.0f ? -1 : static_cast<int>(std::min(value, last));
  }
  void FindBends();

  /// Running sums at [bin + 1]: the changes of the slope of emission up to the begin of a bin, and
  /// the deviations of opaque bins up to its end.
  std::vector<double> Bends, Peaks;
};

/// Gradient opacity by the magnitude of gradients, as a table: linear between entries, constant
/// beyond.
struct GradientTable
{
  /// \throws std::bad_alloc
  explicit GradientTable(const GradientOpacity& opacity);

  double Low = 0.0, PerMagnitude = 0.0; ///< entry = (magnitude - Low) * PerMagnitude
  std::vector<float> Opacities;         ///< empty: 1 everywhere
};

}

#endif
