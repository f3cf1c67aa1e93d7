// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Choice.h"

#include <vtkObject.h>

#include <algorithm>
#include <string>

namespace TemporalCoherence
{

namespace
{

std::string Named(const Choice& choice)
{
  return std::string(choice.Name) + " (" + std::to_string(choice.Value) + ")";
}

/// All of them: "A (0), B (1) or C (2)".
std::string Named(const std::vector<Choice>& choices)
{
  std::string names;
  for (std::size_t i = 0; i < choices.size(); ++i)
  {
    names += i == 0 ? "" : i + 1 < choices.size() ? ", " : " or ";
    names += Named(choices[i]);
  }
  return names;
}

}

//------------------------------------------------------------------------------
void SetChoice(
  vtkObject* object, const char* name, int value, const std::vector<Choice>& choices, int& setting)
{
  const auto find = [&choices](int wanted)
  {
    return std::find_if(choices.begin(), choices.end(),
      [wanted](const Choice& choice) { return choice.Value == wanted; });
  };
  if (find(value) == choices.end())
  {
    vtkErrorWithObjectMacro(object, << name << " must be " << Named(choices) << ", not " << value
                                    << "; it stays " << Named(*find(setting)) << '.');
  }
  else if (value != setting)
  {
    setting = value;
    if (object)
    {
      object->Modified();
    }
  }
}

}
