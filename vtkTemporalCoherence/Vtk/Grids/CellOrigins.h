// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellOrigins_h
#define TemporalCoherence_CellOrigins_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkType.h>

#include <cstdint>
#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

struct Mesh;

/// A cell of the data that a mapper draws.
struct CellOrigin
{
  vtkDataSet* Data = nullptr; ///< only valid as long as the mapper has the data
  unsigned int Block = 0;     ///< flat index in the composite data set; 0 if there is none
  vtkIdType Cell = -1;        ///< -1 if there is none
};

/// Tells of which cells of data sets a mesh was made. Immutable, and shared by frames.
class CellOrigins
{
public:
  /// A data set, and the number of its first cell in the mesh.
  struct Part
  {
    std::int64_t First;
    vtkDataSet* Data;
    unsigned int Block;
  };

  /// \param mesh  its parts that are made of other cells have these cells' numbers
  /// \param parts one for each part of the mesh
  CellOrigins(std::shared_ptr<const Mesh> mesh, std::vector<Part> parts);

  /// \param cell through all parts of the mesh; there is no origin if it is not one of these
  CellOrigin Of(std::int64_t cell) const;

private:
  std::shared_ptr<const Mesh> OfCells;
  std::vector<Part> Parts;
};

}

#endif
