// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FieldFingerprint_h
#define TemporalCoherence_FieldFingerprint_h

#include "Scene/CellBox.h"
#include "Scene/Field.h"

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// What tells samples from those of the step before, which may be gone: a hash for each node of the
/// value-range pyramid, of all samples of its cells, those that neighbours share included.
///
/// Equal hashes are taken for equal samples. A change within eight bytes of a node always changes
/// its hash; any other goes unseen with a probability of about 2^-64. (There is no protection
/// against samples that somebody chose for their hash.) Samples are compared as bytes: 0 and -0 are
/// different.
struct FieldFingerprint
{
  Field Samples;
  std::vector<std::uint64_t> Nodes; ///< x fastest
};

/// Read the whole field once, in parallel.
/// \pre field.HasCells()
/// \throws std::bad_alloc
FieldFingerprint FingerprintOf(const Field& field);

/// Boxes of cells outside of which nothing is seen of the samples that changed. Empty: none did.
/// \pre AreAlike(before.Samples, now.Samples)
std::vector<CellBox> ChangedCells(const FieldFingerprint& before, const FieldFingerprint& now);

}

#endif
