// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FieldStructures_h
#define TemporalCoherence_FieldStructures_h

#include "Acceleration/ActiveCells.h"
#include "Acceleration/FieldFingerprint.h"
#include "Acceleration/ValueRangePyramid.h"
#include "Scene/Field.h"
#include "Scene/Surfaces.h"

#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// The value ranges of a field.
struct FieldRanges
{
  Field Samples;
  /// Also that of others whose samples are equal.
  std::shared_ptr<const ValueRangePyramid> Pyramid = std::make_shared<const ValueRangePyramid>();
};

/// The cells of a field that surfaces can pass through.
struct SurfaceCells
{
  Field Samples;
  Surfaces Isosurfaces;
  std::shared_ptr<const ActiveCells> Active = std::make_shared<const ActiveCells>();
};

/// The structures in which there is no view, shared by all who look at the same data: each is built
/// for the first who asks, and freed when the last who holds it lets go.
class FieldStructures
{
public:
  /// Make `held` the ranges of `field`. What it was is let go first; after an exception it is
  /// empty, never null.
  /// \pre field.HasCells()
  /// \throws std::bad_alloc
  void Provide(const Field& field, std::shared_ptr<const FieldRanges>& held);

  /// The same for the cells that `surfaces` can pass through, from the ranges of their field.
  void Provide(
    const FieldRanges& ranges, const Surfaces& surfaces, std::shared_ptr<const SurfaceCells>& held);

  /// The same for fingerprints; on an exception, `held` stays.
  void Provide(const Field& field, std::shared_ptr<const FieldFingerprint>& held);

  /// Let what is held be that of `field`, whose samples are equal to those that it was made from,
  /// but lie elsewhere. On an exception, it stays.
  void MoveTo(const Field& field, std::shared_ptr<const FieldRanges>& held);
  void MoveTo(const Field& field, std::shared_ptr<const SurfaceCells>& held);

private:
  std::vector<std::weak_ptr<const FieldRanges>> Ranges; ///< those that somebody holds
  std::vector<std::weak_ptr<const SurfaceCells>> Cells;
  std::vector<std::weak_ptr<const FieldFingerprint>> Prints;
};

}

#endif
