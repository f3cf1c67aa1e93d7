// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef UserError_h
#define UserError_h

#include <exception>
#include <functional>
#include <stdexcept>
#include <string>

// A mistake of the user's: one sentence that names it and says what to do.
class UserError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// What to tell of a mistake or a failure: one sentence, printable as it is.
std::string SentenceOf(const std::exception& failure);

// Run a program. Returns its exit status: 0, or 1 after one line for a mistake of the user's or a
// failure.
int RunProgram(const char* name, const std::function<void()>& program);

#endif
