// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_MixingLayer_h
#define Benchmarks_MixingLayer_h

#include "Scene/ScalarType.h"
#include "WaveField.h"

#include <glm/glm.hpp>

#include <cstddef>

/// A volume by formula, of any size: a turbulent layer between a light gas below and a heavy one
/// above. It stands for simulations of the Richtmyer-Meshkov instability, whose volumes are too
/// large to be part of a benchmark.
///
/// Values are about 0 to 20 below the layer and 235 to 255 above it. The layer takes 40 % of the
/// height, which is the axis z. Samples are taken at the centres of cells of the unit cube, so that
/// all sizes show the same.
class MixingLayer
{
public:
  /// \param dimensions samples along each axis; positive
  explicit MixingLayer(const glm::ivec3& dimensions);

  const glm::ivec3& Dimensions() const { return this->Size; }

  /// The samples of one row: values between 0 and 255. Thread-safe.
  /// \param values room for Dimensions().x numbers
  void Row(int y, int z, float* values) const;

  /// The samples of some slices, x fastest. Thread-safe.
  /// \param type    UInt8: rounded values; UInt16: rounded, times 257; Float32: values as they are
  /// \param samples room for them
  void Slices(int first, int count, TemporalCoherence::ScalarType type, void* samples) const;

  /// The samples of some rows, as of Slices(): those from y = first.x and z = first.y. Thread-safe.
  /// \param count rows along y and z
  void Rows(const glm::ivec2& first, const glm::ivec2& count, TemporalCoherence::ScalarType type,
    void* samples) const;

private:
  glm::ivec3 Size;
  WaveField Large; ///< bubbles and spikes
  WaveField Small; ///< folds
};

/// True if MixingLayer::Slices() makes samples of a type.
bool IsTypeOfMixingLayer(TemporalCoherence::ScalarType type);

/// The size of a level of a pyramid. Each level halves the one before; MixingLayer of this size is
/// the level.
/// \param level 0: the volume itself
glm::ivec3 SizeOfLevel(const glm::ivec3& dimensions, int level);

/// The levels of a pyramid. The last one has at most 128 samples along its longest axis.
int NumberOfLevels(const glm::ivec3& dimensions);

#endif
