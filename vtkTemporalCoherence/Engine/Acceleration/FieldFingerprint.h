// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FieldFingerprint_h
#define TemporalCoherence_FieldFingerprint_h

#include "Scene/CellBox.h"
#include "Scene/Field.h"
#include "Scene/SampleChanges.h"

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Hashes of a field's samples, to find what changed when the old samples are gone. Each node of
/// the value-range pyramid has one, of the samples at the first corners of its cells. The last node
/// of a row also has the last samples. So each sample is read once.
///
/// Equal hashes are taken to mean equal samples. A change within eight bytes always changes the
/// hash; any other change is missed with a probability of about 2^-64. (The hash does not withstand
/// samples that were constructed to collide.) Samples are compared as bytes: 0 and -0 differ.
struct FieldFingerprint
{
  Field Samples;
  std::vector<std::uint64_t> Nodes; ///< x fastest
};

/// Read the whole field once, in parallel.
/// \pre field.HasCells()
/// \throws std::bad_alloc
FieldFingerprint FingerprintOf(const Field& field);

/// Read only the nodes around some samples.
/// \param last   fingerprint of the field when all other samples were the same
/// \param within where samples may have changed since
FieldFingerprint FingerprintOf(
  const Field& field, const FieldFingerprint& last, const std::vector<SampleBox>& within);

/// Boxes of cells. Changed samples affect no picture outside of them. Empty if no sample changed.
/// \param within where samples may have changed, if that is known
/// \pre AreAlike(before.Samples, now.Samples)
std::vector<CellBox> ChangedCells(const FieldFingerprint& before, const FieldFingerprint& now,
  const std::optional<std::vector<SampleBox>>& within = std::nullopt);

}

#endif
