// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef UserError_h
#define UserError_h

#include <stdexcept>

// A mistake of the user's: one sentence that names it and says what to do.
class UserError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

#endif
