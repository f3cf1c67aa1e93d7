// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fuzz_Run_h
#define Fuzz_Run_h

#include "Oracle/Tally.h"

#include <cstdint>
#include <vector>

namespace Fuzz
{

/// Bytes of a run that is made from a seed.
constexpr std::size_t BytesOfSeed = 1536;

/// Make a scene of bytes, change it until they are used up and check every frame.
/// Throws a Failure where a contract is broken.
void Run(const std::vector<std::uint8_t>& bytes, Tally& tally);

}

#endif
