// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FieldStructures_h
#define TemporalCoherence_FieldStructures_h

#include "ActiveCells.h"
#include "Field.h"
#include "Surfaces.h"
#include "ValueRangePyramid.h"

#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// The value ranges of a field.
struct FieldRanges
{
  Field Samples;
  ValueRangePyramid Pyramid;
};

/// The cells of a field that surfaces can pass through.
struct SurfaceCells
{
  Field Samples;
  Surfaces Sought;
  ActiveCells Active;
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

  /// The same for the cells that `sought` can pass through, from the ranges of their field.
  void Provide(
    const FieldRanges& ranges, const Surfaces& sought, std::shared_ptr<const SurfaceCells>& held);

private:
  std::vector<std::weak_ptr<const FieldRanges>> Ranges; ///< those that somebody holds
  std::vector<std::weak_ptr<const SurfaceCells>> Cells;
};

}

#endif
