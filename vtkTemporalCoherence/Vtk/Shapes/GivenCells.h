// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GivenCells_h
#define TemporalCoherence_GivenCells_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkType.h>

#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkIdList;
class vtkUnstructuredGrid;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Reads cells of a grid whose arrays may be wrong: each number is checked before it is used.
class GivenCells
{
public:
  /// The points of a face.
  using Face = std::vector<vtkIdType>;

  /// \param name of the grid in messages
  GivenCells(vtkUnstructuredGrid* grid, std::string name = "the input");

  /// The points of a cell.
  /// \param error receives the mistake and its remedy
  /// \return false on error
  bool ReadPoints(vtkIdType cell, vtkIdList* points, std::string& error) const;

  /// The faces of a polyhedron. Faces with fewer than three points are left out.
  /// \param error receives the mistake and its remedy
  /// \return false on error
  bool ReadFaces(vtkIdType cell, std::vector<Face>& faces, std::string& error) const;

  /// For messages: "Cell 7 of the input".
  std::string NameOf(vtkIdType cell) const;

  vtkUnstructuredGrid* const Grid;
  const std::string Name;

private:
  bool HasPoint(vtkIdType point) const;
};

/// The arrays that define the faces of polyhedra, and the modification times of their owners.
std::vector<std::pair<vtkDataArray*, vtkMTimeType>> FaceArraysOf(vtkUnstructuredGrid* grid);

}

#endif
