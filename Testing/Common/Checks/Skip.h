// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Skip_h
#define Testing_Skip_h

#include <vtkTesting.h>

#include <iostream>
#include <string>

/// Tell why a test cannot be run here.
/// \return what the test returns, by which ctest counts it as skipped
inline int Skip(const std::string& why)
{
  std::cout << "SKIPPED: " << why << '\n';
  return VTK_SKIP_RETURN_CODE;
}

/// The same for a real volume.
inline int SkipWithout(const std::string& volume)
{
  return Skip(volume + " is not in a folder that TEMPORAL_COHERENCE_DATA names");
}

#endif
