// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/SettingCheck.h"

#include <iomanip>
#include <limits>
#include <sstream>

namespace TemporalCoherence
{
namespace
{

/// The shortest text that identifies a number, with at least six digits.
std::string InDigits(double value)
{
  std::string text;
  for (int digits = 6; digits <= std::numeric_limits<double>::max_digits10; ++digits)
  {
    std::ostringstream writer;
    writer << std::setprecision(digits) << value;
    text = writer.str();
    std::istringstream reader(text);
    double same = 0.0;
    if (reader >> same && same == value)
    {
      break;
    }
  }
  return text;
}

}

void SettingCheck::operator()(
  const char* setting, double value, const NumberRange& range, const char* remedy)
{
  if (!this->Passed || range.Holds(value))
  {
    return;
  }
  this->Passed = false;
  std::ostringstream what;
  what << setting << " of " << this->Owner.Name;
  if (this->Owner.Place >= 0)
  {
    what << ' ' << this->Owner.Place << " of " << this->Owner.Of;
  }
  what << " must be a finite number between " << range.Low << " and " << range.High << ", got "
       << InDigits(value) << "; call " << remedy << '.';
  this->Error = what.str();
}

void SettingCheck::operator()(
  const char* setting, const double* values, const NumberRange& range, const char* remedy)
{
  for (int i = 0; i < 3; ++i)
  {
    (*this)(setting, values[i], range, remedy);
  }
}

}
