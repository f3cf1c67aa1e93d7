// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GridArray_h
#define TemporalCoherence_GridArray_h

#include "Adaptive/AmrGrids.h"
#include "Grids/MadeFrom.h"
#include "Input/CellOrigins.h"
#include "Input/SamplesOfArray.h"
#include "Input/ScalarChoice.h"
#include "Mesh/Tracing/MeshValues.h"

#include <vtkObjectBase.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// Reads an array that gives the surfaces of a mesh their colours. Keeps computed arrays until the
/// data change.
class GridArray
{
public:
  /// Find the values for the parts of a mesh that was made of data sets. At points that divide
  /// curved cells and polyhedra, their cells are evaluated.
  /// \param read  receives the arrays that are read in place
  /// \param error receives the mistake and its remedy
  /// \return false on error
  /// \throws std::bad_alloc
  bool See(const Mesh& mesh, const CellOrigins& origins, const ArrayChoice& choice,
    std::vector<vtkSmartPointer<vtkObjectBase>>& read, std::string& error);

  /// Find the values for the mesh of an adaptive grid: values of cells, interpolated between their
  /// centres.
  bool See(const Mesh& mesh, AdaptiveGrid* amr, const ArrayChoice& choice, std::string& error);

  const std::vector<PartValues>& Parts() const { return this->OfParts; }

  /// A number that differs whenever values may have changed.
  std::uint64_t Stamp() const { return this->LastStamp; }

private:
  bool IsKnown(const MadeFrom& now, const Mesh& mesh) const;
  void Take(std::vector<PartValues> parts, const MadeFrom& now, const Mesh& mesh);

  MadeFrom From;
  std::uint64_t OfCells = 0, OfPoints = 0; ///< stamps of the mesh
  ArraysInPlace Arrays;
  std::vector<PartValues> OfParts;
  std::uint64_t LastStamp = 0;
};

}

#endif
