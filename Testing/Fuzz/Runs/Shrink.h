// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fuzz_Shrink_h
#define Fuzz_Shrink_h

#include <cstdint>
#include <functional>
#include <vector>

namespace Fuzz
{

/// Fewer and duller bytes that fail still: a run that is told in a few sentences.
/// \param fails makes the run and ends the process with a status other than 0 if it fails; each
///        call is made in a process of its own
std::vector<std::uint8_t> Shrink(std::vector<std::uint8_t> bytes,
  const std::function<bool(const std::vector<std::uint8_t>&)>& fails);

}

#endif
