// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Choice_h
#define TemporalCoherence_Choice_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkObject;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// An allowed value of a setting, and its constant's name.
struct Choice
{
  int Value;
  const char* Name;
};

/// Set a setting of an object to one of its choices. Another value is an error that names them, and
/// the setting stays.
/// \param object reports the error, and is modified by a new value; null if it is no object's
/// \param name   of the setting
void SetChoice(
  vtkObject* object, const char* name, int value, const std::vector<Choice>& choices, int& setting);

}

#endif
