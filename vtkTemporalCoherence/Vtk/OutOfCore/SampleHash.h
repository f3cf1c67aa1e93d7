// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SampleHash_h
#define TemporalCoherence_SampleHash_h

#include "VolumeFiles/VolumeFile.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace TemporalCoherence
{

/// A hash of bytes (FNV-1a, eight bytes at a time).
std::uint64_t HashOf(const void* bytes, std::size_t count, std::uint64_t seed = 0);

/// A hash of what tells a volume from others: its identity, its shape, and the samples of a few
/// chunks spread over it. Unreadable chunks count as zeros.
/// \throws std::bad_alloc
std::uint64_t HashOf(const VolumeFile& file, std::size_t level);

}

#endif
