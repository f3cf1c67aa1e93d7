// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KnotGrid_h
#define TemporalCoherence_KnotGrid_h

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace TemporalCoherence
{

/// A point of the function from progress to the distance at which a ray first reaches it, in whole
/// steps of a KnotGrid.
struct Knot
{
  std::uint16_t Progress;
  std::uint32_t Distance; ///< from where the ray begins
};

/// The grid on which fitted knots lie. So files hold small numbers, and look-ups in what they hold
/// give the same bits (Documentation/ViewFile.md).
struct KnotGrid
{
  /// Steps between the grid's begin and the first isovalue of a band, so that this one can be
  /// found. As many follow the last isovalue.
  static constexpr double Margin = 4.0;
  /// Steps of distance in the tolerance.
  static constexpr double StepsOfTolerance = 4.0;

  double ProgressStep = 0.0, DistanceStep = 0.0;
  std::uint16_t LargestProgress = 0; ///< in steps

  /// The largest progress for a tolerance in voxels, in steps. A jump of the distance is misplaced
  /// by half a step; so one ray in some thousand shows the surface on the wrong side of it. Where
  /// surfaces are to be close, flat ones need finer steps, too.
  static std::uint16_t LargestFor(double tolerance)
  {
    constexpr double coarse = 0.1;
    constexpr int fewest = 12, most = 16;
    const double finer = std::ceil(std::log2(coarse / tolerance));
    const int bits = fewest + static_cast<int>(std::min(std::max(finer, 0.0), 1.0 * most - fewest));
    return static_cast<std::uint16_t>((1u << bits) - 1u);
  }

  double StepsOf(double progress) const { return Margin + progress / this->ProgressStep; }
};

}

#endif
