// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Numbers_h
#define Numbers_h

#include <cstdio>
#include <string>

// As few digits as tell values of a volume apart.
inline std::string AsText(double number)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.5g", number);
  return text;
}

inline std::string Fixed(double number, int digits)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", digits, number);
  return text;
}

#endif
