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

/// What is opaque at once in a bin of values.
struct OpaqueBin
{
  float Boost; ///< what stays where the bin begins, at a peak, emits Value times this
  float Walls; ///< how many ranges that are opaque at once lie before the bin
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

  /// Emission at a value in bins, which is a number.
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

  /// How far emission is at most from the line between that at two values.
  float OffLine(float low, float high) const
  {
    // One bend is farthest from the line if it is half way; that of all is less than their sum.
    const auto first = static_cast<std::size_t>(this->BinAt(low) + 1);
    const auto last = static_cast<std::size_t>(this->BinAt(high) + 1);
    const double bends = this->Bends[last] - this->Bends[first];
    // What lies below the range looks as the beginning of its first bin.
    const double peaks = this->Peaks[std::max<std::size_t>(last, 1)] -
      this->Peaks[std::max<std::size_t>(first, 1) - 1];
    return static_cast<float>(0.25 * static_cast<double>(high - low) * bends + peaks);
  }

  /// True if something is opaque at once in a bin, or where it begins.
  bool IsOpaqueIn(std::size_t bin) const
  {
    return this->Opaque[bin].Boost != 1.0f || this->All[bin].Value[0] > this->MostCounted;
  }

  double Low, PerValue;
  int Bins;                      ///< within the range
  std::vector<EmissionBin> All;  ///< and one for what lies above the range
  std::vector<OpaqueBin> Opaque; ///< of the same bins
  float Beyond; ///< values that are farther than this from the range are beyond it, in bins
  /// Where values differ less, in bins, the difference of their sums has too few digits.
  float Closest;
  float LeastOrdered;             ///< where values differ less in Sum[0], Order has too few digits
  float MostExtinction;           ///< that stands for an opacity of 1
  bool AreOpaqueAnywhere = false; ///< at some value, at once
  float MostCounted; ///< extinction above this is opaque at once, and Sum does not count all of it
  /// The largest change of emission from bin to bin, for blocks of bins and as many blocks on
  /// each side as the level tells, 1, 2, 4 and so on: [level * blocks + block].
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

  /// The sum of all changes of the slope of emission up to the beginning of a bin, and of what is
  /// opaque at once up to its end: [bin + 1].
  std::vector<double> Bends, Peaks;
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
