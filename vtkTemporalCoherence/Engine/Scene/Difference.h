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

/// How isovalues are computed with beside samples of a type, so that arithmetic neither overflows
/// nor loses a sign to underflow.
///
/// Samples but doubles have limits, beyond which isovalues are all alike: an isovalue is moved
/// there from far outside. They also have a smallest number, below which isovalues that are not 0
/// are all alike: such an isovalue is moved away from 0. Neither takes it past a sample.
///
/// Doubles have no such limits. Differences of them are multiplied by a power of two, which changes
/// no digit and takes the largest of them to where there is room above and below.
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

  /// The same for the samples of a field.
  static IsovalueScale For(
    ScalarType samples, const ValueBand& isovalues, const glm::dvec2& finiteRange)
  {
    return DispatchScalarType(
      samples, [&](auto sample) { return For<decltype(sample)>(isovalues, finiteRange); });
  }

  /// An isovalue as it is computed with, in units of samples.
  double Moved(double isovalue) const
  {
    const double moved = std::min(std::max(isovalue, -this->Largest), this->Largest);
    return moved != 0.0 && std::abs(moved) < this->Smallest ? std::copysign(this->Smallest, moved)
                                                            : moved;
  }

  /// The same in units of differences.
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

/// Differences of samples from one isovalue, with the exact sign and full relative precision near
/// the isovalue, in the type the engine computes with. (Integers beyond 2^53 are rounded to
/// double.)
///
/// What is not finite stays harmless: differences are clamped to +-R, R being the largest
/// difference of a finite sample, and NaN reads as -R, below every isovalue.
///
/// A sample that is less than the isovalue has a difference that stays less than 0 in sums of
/// shares of it: signs survive interpolation, also in arithmetic that takes denormal numbers for 0.
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

  /// The same in the units of a scale.
  Difference(double isovalue, const glm::dvec2& finiteRange, const IsovalueScale& scale)
    : Isovalue(scale.Moved(isovalue))
    , Factor(scale.Factor)
    , High(static_cast<Real>(scale.Scaled(isovalue)))
    , Low(static_cast<Real>(scale.Scaled(isovalue) - static_cast<double>(High)))
    , Limit(static_cast<Real>(LimitFor(scale.LargestFrom(isovalue, finiteRange))))
  {
  }

  /// In units of samples: the isovalue, as the sum of two numbers, and the largest difference from
  /// it.
  std::array<double, 3> Parts() const
  {
    constexpr double largest = std::numeric_limits<double>::max() / 4.0;
    return { IsScaled ? this->Isovalue : static_cast<double>(this->High),
      static_cast<double>(this->Low),
      std::min(static_cast<double>(this->Limit) / this->Factor, largest) };
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

  /// Differences less than 0 are no nearer to it: shares of less than this would be denormal.
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
