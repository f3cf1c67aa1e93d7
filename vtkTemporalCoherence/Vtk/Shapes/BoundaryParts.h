// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BoundaryParts_h
#define TemporalCoherence_BoundaryParts_h

#include "Shapes/CellDivision.h"
#include "Shapes/SharedPoints.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkType.h>

#include <cstddef>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkIdList;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Numbers of parts of faces and edges: the largest number of any cell around them. Corners
/// identify a face or edge, so that all cells around it get one number.
class BoundaryParts
{
public:
  /// Add a cell that is divided into `parts`. Undivided cells need not be added.
  /// \throws std::bad_alloc
  void Add(const ShapeFrame& frame, vtkIdList* points, int parts);

  /// The numbers of parts of a cell. \p inside is its inner number.
  CellParts Of(const ShapeFrame& frame, vtkIdList* points, int inside) const;

private:
  /// A hash of the numbers of corners. After a collision, both sides have the larger number of
  /// parts.
  struct Entry
  {
    std::uint64_t Key = 0;
    int Parts = 0; ///< 0: unused entry
  };

  std::size_t PlaceOf(std::uint64_t key) const;
  void Raise(std::uint64_t key, int parts);
  int PartsOf(std::uint64_t key) const;
  void Grow();

  std::vector<Entry> Entries; ///< the size is a power of two
  std::size_t Used = 0;
};

}

#endif
