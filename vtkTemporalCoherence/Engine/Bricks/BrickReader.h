// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BrickReader_h
#define TemporalCoherence_BrickReader_h

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// Gives the samples of a volume that lies elsewhere.
class BrickReader
{
public:
  virtual ~BrickReader() = default;

  /// Read a box of samples. Thread-safe. What cannot be read gets a value that stands for nothing;
  /// the reader keeps the mistake.
  /// \param first, size of the box, within the volume
  /// \param samples     of the box: the first one
  /// \param strides     samples from one to the next along y and z
  virtual void Read(const glm::ivec3& first, const glm::ivec3& size, void* samples,
    const glm::i64vec2& strides) const = 0;

protected:
  BrickReader() = default;
  BrickReader(const BrickReader&) = default;
  BrickReader& operator=(const BrickReader&) = default;
};

}

#endif
