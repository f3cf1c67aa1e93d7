// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Waves_h
#define Testing_Waves_h

#include <cmath>
#include <limits>

/// A smooth field, from about -1.3 to 1.3.
inline double Wave(int i, int j, int k)
{
  return std::sin(0.4 * i) * std::cos(0.3 * j + 0.2 * k) + 0.3 * std::sin(0.9 * k);
}

/// The same times 1e30, with samples that are not finite: no numbers, and infinities of both signs.
inline double WaveWithHoles(int i, int j, int k)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return i % 7 == 0 ? std::numeric_limits<double>::quiet_NaN()
    : j % 9 == 0    ? (k % 2 ? infinity : -infinity)
                    : 1e30 * Wave(i, j, k);
}

#endif
