// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Mutations_h
#define TemporalCoherence_Mutations_h

#include <cstdlib>

namespace TemporalCoherence
{

/// How often a test changes a file at random.
/// \param usual number, which is tested in a second or two. The environment variable
///              TEMPORAL_COHERENCE_MUTATIONS replaces it, for long runs
inline int NumberOfMutations(int usual)
{
  const char* const number = std::getenv("TEMPORAL_COHERENCE_MUTATIONS");
  return number ? std::atoi(number) : usual;
}

}

#endif
