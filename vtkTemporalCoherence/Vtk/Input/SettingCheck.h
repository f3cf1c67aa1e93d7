// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SettingCheck_h
#define TemporalCoherence_SettingCheck_h

#include <cmath>
#include <string>

namespace TemporalCoherence
{

/// The range of a setting.
struct NumberRange
{
  double Low, High;

  bool Holds(double value) const
  {
    return std::isfinite(value) && value >= this->Low && value <= this->High;
  }
};

/// Ranges wide enough for any sensible setting, and narrow enough that no product of settings
/// exceeds the range of floats, 1e38.
namespace Allowed
{
constexpr NumberRange Coefficient = { -1e6, 1e6 }; ///< ambient, diffuse, specular
constexpr NumberRange SpecularPower = { 0.0, 1e6 };
constexpr NumberRange Color = { -1e3, 1e3 };
constexpr NumberRange ColorWindow = { -1e4, 1e4 };
constexpr NumberRange Opacity = { -1e6, 1e6 };        ///< clamped to [0, 1]
constexpr NumberRange FieldValue = { -1e300, 1e300 }; ///< where functions of values have nodes
constexpr NumberRange Distance = { 1e-30, 1e30 };     ///< in the world, positive
constexpr NumberRange GradientMagnitude = { -1e100, 1e100 };
constexpr NumberRange Intensity = { -1e18, 1e18 };
constexpr NumberRange Attenuation = { -1e30, 1e30 };
constexpr NumberRange Exponent = { 0.0, 128.0 };
constexpr NumberRange Degrees = { -1e6, 1e6 };
constexpr NumberRange Place = { -1e38, 1e38 };
}

/// The object whose settings are checked, in the user's words. Strings are only built on error.
struct SettingOwner
{
  const char* Name;    ///< "the volume's property", or one of many, such as "light"
  int Place = -1;      ///< which one of many
  const char* Of = ""; ///< their owner, "the renderer"
};

/// Checks the settings of one object. The first invalid number (infinite, NaN or out of range) is
/// an error.
class SettingCheck
{
public:
  /// \param error receives the mistake and its remedy; must outlive this
  SettingCheck(const SettingOwner& owner, std::string& error)
    : Owner(owner)
    , Error(error)
  {
  }

  /// \param remedy the function to call with another number
  void operator()(const char* setting, double value, const NumberRange& range, const char* remedy);

  /// Check three numbers.
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
