// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RangeScan_h
#define TemporalCoherence_RangeScan_h

#include "Scene/Field.h"
#include "Scene/KnownRanges.h"

#include <cstddef>
#include <memory>

namespace TemporalCoherence
{

/// Finds the value ranges of a field in one pass over its samples, part by part.
class RangeScan
{
public:
  /// Bytes of the ranges of a field with this many samples along each axis.
  static std::size_t BytesFor(ScalarType type, const glm::ivec3& dimensions);

  /// \param room for BytesFor() bytes
  RangeScan(ScalarType type, const glm::ivec3& dimensions, std::shared_ptr<std::byte> room);

  /// Scan some rows of nodes, in parallel.
  /// \param field of the whole size. Only the samples of these nodes are read, and those at the
  ///              beginning of the next ones
  /// \param first y and z of the first row, counted in nodes
  /// \param count rows along y and z
  void Scan(const Field& field, const glm::ivec2& first, const glm::ivec2& count);

  /// The ranges, once all nodes are scanned.
  KnownRanges Finish();

private:
  ScalarType Type;
  glm::ivec3 Nodes;
  std::shared_ptr<std::byte> Room;
  glm::dvec2 Finite;
  std::vector<std::uint64_t> WithNaN;
};

}

#endif
