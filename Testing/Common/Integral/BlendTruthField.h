// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BlendTruthField_h
#define Testing_BlendTruthField_h

#include "Scene/FrameKey.h"
#include "Scene/GridCoordinates.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <vector>

/// The components of a volume in double precision, cell by cell, for BlendTruth.
class BlendTruthField
{
public:
  static constexpr std::size_t MostComponents = 4;

  /// One cell, and what its eight samples say of each component.
  struct Cell
  {
    glm::ivec3 Number{ -1 };
    bool IsVisible = false; ///< it is shown, and all of its samples are finite
    glm::dvec3 Low, Size;   ///< in index space
    std::array<std::array<double, 8>, MostComponents> Values;
    std::array<std::array<glm::dvec3, 8>, MostComponents> Gradients; ///< in index space
    std::array<double, 8> Labels{};                                  ///< if the volume has some
  };

  /// \param coordinates of the samples; null: they lie at integers
  BlendTruthField(
    const TemporalCoherence::FrameKey& key, const TemporalCoherence::GridCoordinates* coordinates);

  std::size_t Components() const { return this->Fields.size(); }
  bool IsNearest() const
  {
    return this->Fields[0].Between == TemporalCoherence::Interpolation::Nearest;
  }

  /// Where along an axis of index space the field is not smooth, ascending from 0.
  const std::vector<double>& Breaks(int axis) const
  {
    return this->BreaksAlong[static_cast<std::size_t>(axis)];
  }
  glm::dvec3 Last() const;

  /// Read the cell that holds a point, unless it is that cell already.
  void Read(const glm::dvec3& point, Cell& cell) const;

  double ValueAt(const Cell& cell, std::size_t component, const glm::dvec3& point) const;

  /// The label of the nearest sample.
  static double LabelAt(const Cell& cell, const glm::dvec3& point);

  /// In index space.
  glm::dvec3 GradientAt(const Cell& cell, std::size_t component, const glm::dvec3& point) const;

private:
  static double Sample(const TemporalCoherence::Field& field, const glm::ivec3& at);
  double Sample(std::size_t component, const glm::ivec3& at) const
  {
    return Sample(this->Fields[component], at);
  }
  glm::dvec3 GradientOfSample(std::size_t component, const glm::ivec3& at) const;
  glm::dvec3 ShareOf(const Cell& cell, const glm::dvec3& point) const;

  std::vector<TemporalCoherence::Field> Fields;
  const TemporalCoherence::Field* Labels; ///< or null
  std::array<std::vector<double>, 3> Planes, BreaksAlong;
};

#endif
