// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Difference_h
#define TemporalCoherence_Difference_h

#include "Scene/Field.h"
#include "Scene/Surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace TemporalCoherence
{

/// Adapts isovalues to the type of the samples, so that their differences neither overflow nor lose
/// their sign to underflow.
///
/// Every type but double has limits. All isovalues beyond a limit meet the same samples, so an
/// isovalue from far outside is moved to the limit. Every type also has a smallest positive number.
/// A smaller isovalue that is not 0 is moved away from 0. An isovalue is never moved past a sample.
///
/// Doubles have no such limits. A power of two scales their differences. This changes no digit, and
/// leaves room above and below the largest difference.
struct IsovalueScale
{
  /// \tparam T           type of the samples
  /// \param isovalues   that differences will be taken from, or compared with
  /// \param finiteRange smallest and largest finite sample of the field
  template <typename T>
  static IsovalueScale For(const ValueBand& isovalues, const glm::dvec2& finiteRange)
  {
    IsovalueScale scale;
    if constexpr (std::is_same_v<T, double>)
    {
      const double largest = std::max({ std::abs(isovalues.Low), std::abs(isovalues.High),
        std::abs(finiteRange.x), std::abs(finiteRange.y) });
      constexpr int exponent = 900, most = 1000;
      scale.Factor =
        largest > 0.0 ? std::ldexp(1.0, std::min(exponent - std::ilogb(largest), most)) : 1.0;
    }
    else
    {
      constexpr bool isInFloat = sizeof(RealOf<T>) == sizeof(float);
      scale.Largest = isInFloat ? 1e30 : 1e300;
      scale.Smallest = isInFloat ? 0x1p-100 : 0x1p-900;
    }
    return scale;
  }

  /// The scale for the samples of a field.
  static IsovalueScale For(
    ScalarType samples, const ValueBand& isovalues, const glm::dvec2& finiteRange)
  {
    return DispatchScalarType(
      samples, [&](auto sample) { return For<decltype(sample)>(isovalues, finiteRange); });
  }

  /// The adapted isovalue, in units of samples.
  double Moved(double isovalue) const
  {
    const double moved = std::min(std::max(isovalue, -this->Largest), this->Largest);
    return moved != 0.0 && std::abs(moved) < this->Smallest ? std::copysign(this->Smallest, moved)
                                                            : moved;
  }

  /// The moved isovalue in units of differences.
  double Scaled(double isovalue) const { return this->Moved(isovalue) * this->Factor; }

  /// The largest difference of finite samples from an isovalue, in units of differences.
  double LargestFrom(double isovalue, const glm::dvec2& finiteRange) const
  {
    const double from = this->Scaled(isovalue);
    return std::max(
      std::abs(from - finiteRange.x * this->Factor), std::abs(finiteRange.y * this->Factor - from));
  }

  double Factor = 1.0; ///< units of differences in one of samples
  double Largest = std::numeric_limits<double>::max(), Smallest = 0.0; ///< isovalues
};

/// The parameters of a difference in double.
struct DifferenceInDouble
{
  double Isovalue; ///< samples below it have differences of at most -Least
  double Factor, High, Low, Limit, Least;
};

/// Differences of samples from one isovalue, with the exact sign and full relative precision near
/// the isovalue, in the type the engine computes with. (Integers beyond 2^53 are rounded to
/// double.)
///
/// Infinities do no harm: differences are clamped to +-R, where R is the largest difference of a
/// finite sample. NaN, whose cells are hidden, counts as -R.
///
/// Signs survive interpolation: a difference below 0 stays below 0 when it is multiplied by weights
/// and summed, even if the hardware flushes denormal numbers to 0.
template <typename T>
class Difference
{
public:
  using Real = RealOf<T>;

  /// \param finiteRange smallest and largest finite sample of the field
  Difference(double isovalue, const glm::dvec2& finiteRange)
    : Difference(isovalue, finiteRange, IsovalueScale::For<T>({ isovalue, isovalue }, finiteRange))
  {
  }

  /// Differences from an isovalue in the units of a scale.
  Difference(double isovalue, const glm::dvec2& finiteRange, const IsovalueScale& scale)
    : Isovalue(scale.Moved(isovalue))
    , Factor(scale.Factor)
    , High(static_cast<Real>(scale.Scaled(isovalue)))
    , Low(static_cast<Real>(scale.Scaled(isovalue) - static_cast<double>(High)))
    , Limit(static_cast<Real>(LimitFor(scale.LargestFrom(isovalue, finiteRange))))
  {
  }

  /// In units of samples: the isovalue as the sum of two numbers, and the largest difference from
  /// it.
  std::array<double, 3> Parts() const
  {
    constexpr double largest = std::numeric_limits<double>::max() / 4.0;
    return { IsScaled ? this->Isovalue : static_cast<double>(this->High),
      static_cast<double>(this->Low),
      std::min(static_cast<double>(this->Limit) / this->Factor, largest) };
  }

  /// The parameters of operator(), for kernels.
  DifferenceInDouble InDouble() const
  {
    static_assert(std::is_same_v<Real, double>);
    constexpr double none = -std::numeric_limits<double>::infinity();
    return { IsScaled ? this->Isovalue : none, this->Factor, this->High, this->Low, this->Limit,
      Least };
  }

  Real operator()(T sample) const
  {
    if constexpr (IsScaled)
    {
      const double difference = this->Clamp(sample * this->Factor - this->High);
      return sample < this->Isovalue ? std::min(difference, -Least) : difference;
    }
    else
    {
      // High and Low together are the isovalue to twice the precision of Real. The first difference
      // is exact wherever the second one matters.
      const Real difference = (static_cast<Real>(sample) - this->High) - this->Low;
      return std::is_floating_point_v<T> ? this->Clamp(difference) : difference;
    }
  }

  /// In units of samples.
  double Unscaled(double difference) const { return difference / this->Factor; }

private:
  static constexpr bool IsScaled = std::is_same_v<T, double>;

  /// Negative differences stay at least this far from 0: parts of a smaller number would be
  /// denormal.
  static constexpr double Least = 0x1p-960;

  static double LimitFor(double largest) { return largest > 0.0 ? largest : 1.0; }

  Real Clamp(Real difference) const
  {
    // Both comparisons are false for NaN.
    const Real raised = difference > -this->Limit ? difference : -this->Limit;
    return raised < this->Limit ? raised : this->Limit;
  }

  double Isovalue, Factor;
  Real High, Low, Limit;
};

}

#endif
