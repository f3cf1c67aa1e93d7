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

/// The value ranges of a field, and its hidden cells.
struct FieldRanges
{
  Field Samples; ///< with Field::Hidden
  /// Shared by fields with equal samples.
  std::shared_ptr<const ValueRangePyramid> Pyramid = std::make_shared<const ValueRangePyramid>();
};

/// The cells of a field that surfaces can pass through.
struct SurfaceCells
{
  Field Samples;
  Surfaces Isosurfaces;
  std::shared_ptr<const ActiveCells> Active = std::make_shared<const ActiveCells>();
};

/// Visible values of a field.
struct VisibleValues
{
  std::shared_ptr<const FieldRanges> Ranges;
  std::vector<ValueBand> Bands;
  /// Labels of samples, if the bands count for some of them only (ActiveCells::SeenValues).
  std::shared_ptr<const LabelSets> Labels;
  std::vector<double> CountFor; ///< these labels, ascending
};

inline bool operator==(const VisibleValues& a, const VisibleValues& b)
{
  return a.Ranges->Samples == b.Ranges->Samples && a.Bands == b.Bands && a.Labels == b.Labels &&
    a.CountFor == b.CountFor;
}

/// The cells of a field that hold a visible value of any of several components.
struct VisibleCells
{
  std::vector<VisibleValues> Values;
  std::shared_ptr<const ActiveCells> Active = std::make_shared<const ActiveCells>();
};

/// Structures that do not depend on the view. All viewers of the same data share them: the first
/// request builds a structure, and the last release frees it.
class FieldStructures
{
public:
  /// Set `held` to the ranges and hidden cells of `field`, releasing what it held before. After an
  /// exception it is empty, never null.
  /// \pre field.HasCells()
  /// \throws std::bad_alloc
  void Provide(const Field& field, std::shared_ptr<const FieldRanges>& held);

  /// Provide the active cells of `surfaces`, built from the ranges of their field.
  void Provide(
    const FieldRanges& ranges, const Surfaces& surfaces, std::shared_ptr<const SurfaceCells>& held);

  /// Provide the cells that hold visible values.
  void Provide(const std::vector<VisibleValues>& values, std::shared_ptr<const VisibleCells>& held);

  /// Provide the fingerprint of a field. On an exception, `held` is unchanged.
  void Provide(const Field& field, std::shared_ptr<const FieldFingerprint>& held);

  /// Reassign `held` to `field`, whose samples are equal but lie elsewhere in memory. On an
  /// exception, `held` is unchanged.
  void MoveTo(const Field& field, std::shared_ptr<const FieldRanges>& held);
  void MoveTo(const Field& field, std::shared_ptr<const SurfaceCells>& held);

private:
  std::vector<std::weak_ptr<const FieldRanges>> Ranges; ///< still in use
  std::vector<std::weak_ptr<const SurfaceCells>> Cells;
  std::vector<std::weak_ptr<const VisibleCells>> Visible;
  std::vector<std::weak_ptr<const FieldFingerprint>> Prints;
};

}

#endif
