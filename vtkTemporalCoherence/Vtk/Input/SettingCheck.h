// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SettingCheck_h
#define TemporalCoherence_SettingCheck_h

#include <cmath>
#include <string>

namespace TemporalCoherence
{

/// The numbers that a setting may have.
struct NumberRange
{
  double Low, High;

  bool Holds(double value) const
  {
    return std::isfinite(value) && value >= this->Low && value <= this->High;
  }
};

/// So wide that no sensible setting is refused, and so narrow that no product of settings leaves
/// the range of floats, 1e38.
namespace Allowed
{
constexpr NumberRange Coefficient = { -1e6, 1e6 }; ///< ambient, diffuse, specular
constexpr NumberRange SpecularPower = { 0.0, 1e6 };
constexpr NumberRange Color = { -1e3, 1e3 };
constexpr NumberRange ColorWindow = { -1e4, 1e4 };
constexpr NumberRange Opacity = { -1e6, 1e6 }; ///< counts as clamped to [0, 1]
constexpr NumberRange GradientMagnitude = { -1e100, 1e100 };
constexpr NumberRange Intensity = { -1e18, 1e18 };
constexpr NumberRange Attenuation = { -1e30, 1e30 };
constexpr NumberRange Exponent = { 0.0, 128.0 };
constexpr NumberRange Degrees = { -1e6, 1e6 };
constexpr NumberRange Place = { -1e38, 1e38 };
}

/// Whose settings they are, in the user's words. No text is made of it before one is refused.
struct SettingOwner
{
  const char* Name;    ///< "the volume's property", or where there are many, such as "light"
  int Place = -1;      ///< which of them
  const char* Of = ""; ///< whose they are, "the renderer"
};

/// Refuses settings of one object that are no numbers, or absurd ones; tells of the first of them.
class SettingCheck
{
public:
  /// \param error gets what is wrong and what to do about it; must outlive this
  SettingCheck(const SettingOwner& owner, std::string& error)
    : Owner(owner)
    , Error(error)
  {
  }

  /// \param remedy what to call with another number
  void operator()(const char* setting, double value, const NumberRange& range, const char* remedy);

  /// The same for three numbers.
  void operator()(
    const char* setting, const double* values, const NumberRange& range, const char* remedy);

  bool HasPassed() const { return this->Passed; }

private:
  SettingOwner Owner;
  std::string& Error;
  bool Passed = true;
};

}

#endif
