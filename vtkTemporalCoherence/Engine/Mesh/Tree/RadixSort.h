// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RadixSort_h
#define TemporalCoherence_RadixSort_h

#include "Scene/DefaultInitAllocator.h"

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

using SortKeys = std::vector<std::uint64_t, DefaultInitAllocator<std::uint64_t>>;

/// Sort keys begin .. end - 1 by `bits` bits from bit `shift` on, in parallel. Keys that are equal
/// there stay in their order.
/// \param spare as many keys as `keys`, whose values are lost
void SortByRadix(
  SortKeys& keys, SortKeys& spare, std::int64_t begin, std::int64_t end, int shift, int bits);

}

#endif
