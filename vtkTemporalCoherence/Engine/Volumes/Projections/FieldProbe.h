// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FieldProbe_h
#define TemporalCoherence_FieldProbe_h

#include "Scene/Field.h"
#include "Scene/GridCoordinates.h"
#include "Scene/RayBatch.h"

namespace TemporalCoherence
{

/// Evaluates a field with samples at single points.
class FieldProbe
{
public:
  /// \param grid where samples lie; null: at integers
  FieldProbe(const Field& field, const GridCoordinates* grid);

  /// The value on a ray at t.
  double At(const RayBatch& rays, std::size_t ray, double t) const;

private:
  double ValueAt(const RayBatch& rays, std::size_t ray, double t) const;

  Field Samples;
  const GridCoordinates* Grid;
};

}

#endif
