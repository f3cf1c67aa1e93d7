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

/// Into how many parts faces and edges are divided: into as many as the finest cell around them.
/// They are known by their corners, so that all cells around them are told the same.
class BoundaryParts
{
public:
  /// A cell is divided into so many parts. Those that are whole need not be told.
  /// \throws std::bad_alloc
  void Add(const ShapeFrame& frame, vtkIdList* points, int parts);

  /// The parts of a cell with so many inside.
  CellParts Of(const ShapeFrame& frame, vtkIdList* points, int inside) const;

private:
  /// 64 bits of the numbers of corners. If two names had the same bits, both would get the larger
  /// number of parts.
  struct Entry
  {
    std::uint64_t Key = 0;
    int Parts = 0; ///< 0: of nothing
  };

  std::size_t PlaceOf(std::uint64_t key) const;
  void Raise(std::uint64_t key, int parts);
  int PartsOf(std::uint64_t key) const;
  void Grow();

  std::vector<Entry> Entries; ///< as many as a power of two
  std::size_t Used = 0;
};

}

#endif
