// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SampleBytes_h
#define TemporalCoherence_SampleBytes_h

#include "Scene/ScalarType.h"

#include <array>
#include <cstddef>

namespace TemporalCoherence
{

/// The bytes of a sample, in this machine's order. Smaller samples use the first bytes.
using SampleBytes = std::array<unsigned char, 8>;

/// Reverse the bytes of each sample.
void SwapSampleBytes(ScalarType type, void* samples, std::size_t count);

/// Set all samples to one value.
void FillSamples(ScalarType type, const SampleBytes& value, void* samples, std::size_t count);

/// Whether the first byte of a number in memory is its lowest.
bool IsLittleEndianMachine();

}

#endif
