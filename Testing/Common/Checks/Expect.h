// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Expect_h
#define Testing_Expect_h

#include <iostream>
#include <string>

/// Number of failed expectations of the running test.
inline int Failures = 0;

/// Print and count a condition that does not hold, and go on.
inline void Expect(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << '\n';
    ++Failures;
  }
}

#endif
