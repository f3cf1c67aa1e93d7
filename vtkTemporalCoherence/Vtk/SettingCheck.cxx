// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SettingCheck.h"

#include <sstream>

namespace TemporalCoherence
{

void SettingCheck::operator()(
  const std::string& setting, double value, const NumberRange& range, const std::string& remedy)
{
  if (!this->Passed || range.Holds(value))
  {
    return;
  }
  this->Passed = false;
  std::ostringstream what;
  what << setting << " of " << this->Owner << " must be a finite number between " << range.Low
       << " and " << range.High << ", got " << value << "; call " << remedy << '.';
  this->Error = what.str();
}

void SettingCheck::operator()(const std::string& setting, const double* values,
  const NumberRange& range, const std::string& remedy)
{
  for (int i = 0; i < 3; ++i)
  {
    (*this)(setting, values[i], range, remedy);
  }
}

}
