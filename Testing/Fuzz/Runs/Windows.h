// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fuzz_Windows_h
#define Fuzz_Windows_h

#include "Oracle/Tally.h"

#include <cstdint>
#include <vector>

namespace Fuzz
{

/// The same in render windows, which are opened, resized, shared and closed.
namespace Windows
{

/// True if a window can be opened here.
bool AreThere();

/// Make a scene of bytes, show it in windows and change it until the bytes are used up.
/// Throws a Failure where a contract is broken.
void Run(const std::vector<std::uint8_t>& bytes, Tally& tally);

}

}

#endif
