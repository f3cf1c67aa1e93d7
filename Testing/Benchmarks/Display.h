// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_Display_h
#define Benchmarks_Display_h

#include <string>

/// Ask for a display before long measurements, not after.
/// \throws Measuring::Failure if windows need one and there is none
void RequireDisplay();

/// True if windows can be drawn in; if not, a sentence on the error stream says what is left out.
bool HasDisplayOrTell(const std::string& whatIsLeftOut);

#endif
