// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Expect_h
#define Testing_Expect_h

#include <iostream>
#include <string>

/// Expectations of the running test that were not met.
inline int Failures = 0;

/// Tell of a condition that does not hold, count it, and go on.
inline void Expect(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << '\n';
    ++Failures;
  }
}

#endif
