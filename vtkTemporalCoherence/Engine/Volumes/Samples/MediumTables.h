// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MediumTables_h
#define TemporalCoherence_MediumTables_h

#include "Scene/Blending.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// An opacity in single precision. Rounding makes no opacity 1.
inline float SingleOpacity(double opacity)
{
  constexpr float mostBelowOne = 0.99999994f;
  return opacity < 1.0 ? std::min(static_cast<float>(opacity), mostBelowOne) : 1.0f;
}

/// Opacity, red, green and blue between two nodes of a transfer function: linear.
struct MediumBin
{
  std::array<float, 4> Value; ///< where it begins
  std::array<float, 4> Rise;  ///< from there to its end
};

/// The transfer function of one component, for kernels. Values are counted in bins: (value - Low) *
/// PerValue + 1. Bin 0 lies below the range of the transfer function, the last bin above it. Both
/// are constant.
struct MediumTable
{
  /// \throws std::bad_alloc
  explicit MediumTable(const TransferFunction& transfer);

  /// True if some value of a range, in bins, has an opacity.
  bool IsSeen(double low, double high) const
  {
    return this->SeenBefore[this->IndexOf(high) + 1] > this->SeenBefore[this->IndexOf(low)];
  }

  double Low, PerValue;
  std::vector<MediumBin> Bins;

private:
  std::size_t IndexOf(double bin) const
  {
    const auto last = static_cast<double>(this->Bins.size() - 1);
    return bin > 0.0 ? static_cast<std::size_t>(bin < last ? bin : last) : 0;
  }

  std::vector<std::uint32_t> SeenBefore; ///< number of visible bins before each bin
};

}

#endif
