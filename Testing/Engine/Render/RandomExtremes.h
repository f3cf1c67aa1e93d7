// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_RandomExtremes_h
#define Testing_RandomExtremes_h

#include "Checks/Infinity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

constexpr double Huge = std::numeric_limits<double>::max();
constexpr double Denormal = std::numeric_limits<double>::denorm_min();

/// Numbers at which arithmetic goes wrong first.
inline const std::vector<double>& ExtremeNumbers()
{
  static const std::vector<double> numbers = { 0.0, 1.0, 2.0, 1e-30, 1e-38, 1e-39, 1.5e-45, 7e-46,
    1e-46, 1e-155, 1e-200, 2.3e-308, std::numeric_limits<double>::min(), 1e-310, Denormal,
    3.0 * Denormal, 1e15, 1e19, 1e30, 3.4e38, 4e38, 1e155, 1e200, 1e299, 1e300, 2e300, 1e305, 1e307,
    0.6 * Huge, Huge };
  return numbers;
}

class RandomExtremes
{
public:
  explicit RandomExtremes(unsigned int seed)
    : Engine(seed)
  {
    // Few magnitudes at a time, or none would ever meet.
    for (double& number : this->Numbers)
    {
      number = ExtremeNumbers()[this->Below(ExtremeNumbers().size())];
    }
  }

  std::size_t Below(std::size_t count)
  {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(this->Engine);
  }

  bool IsOneOf(std::size_t count) { return this->Below(count) == 0; }

  double Finite()
  {
    double number = this->Numbers[this->Below(this->Numbers.size())];
    switch (this->Below(6))
    {
      case 0:
        number *= std::uniform_real_distribution<double>(0.0, 1.0)(this->Engine);
        break;
      case 1:
        number = std::nextafter(number, this->IsOneOf(2) ? Huge : -Huge);
        break;
      default:
        break;
    }
    return this->IsOneOf(2) ? number : -number;
  }

  template <typename T>
  T Sample(bool canBeNotFinite)
  {
    if constexpr (std::is_floating_point_v<T>)
    {
      if (canBeNotFinite && this->IsOneOf(8))
      {
        const T infinity = std::numeric_limits<T>::infinity();
        return this->IsOneOf(2) ? std::numeric_limits<T>::quiet_NaN()
          : this->IsOneOf(2)    ? infinity
                                : -infinity;
      }
    }
    const auto low = static_cast<double>(std::numeric_limits<T>::lowest());
    const auto high = static_cast<double>(std::numeric_limits<T>::max());
    const double number = std::clamp(this->Finite(), low, high);
    return number >= high ? std::numeric_limits<T>::max() : static_cast<T>(number);
  }

private:
  std::mt19937 Engine;
  std::array<double, 3> Numbers;
};

#endif
