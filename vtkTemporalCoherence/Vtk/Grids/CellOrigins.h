// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellOrigins_h
#define TemporalCoherence_CellOrigins_h

#include <vtkDataSet.h>
#include <vtkType.h>
#include <vtkWeakPointer.h>

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

struct Mesh;

/// A cell of the data that a mapper draws.
struct CellOrigin
{
  vtkDataSet* Data = nullptr; ///< null if it is gone
  unsigned int Block = 0;     ///< flat index in the composite data set; 0 if there is none
  vtkIdType Cell = -1;        ///< -1 if there is none
};

/// The point of a cell that is nearest to a place in the data's coordinates; -1 if there is none.
vtkIdType NearestPointOf(const CellOrigin& cell, const glm::dvec3& place);

/// Tells of which cells of data sets a mesh was made. Immutable, and shared by frames.
class CellOrigins
{
public:
  /// A data set, and the number of its first cell in the mesh.
  struct Part
  {
    std::int64_t First;
    vtkWeakPointer<vtkDataSet> Data;
    unsigned int Block;
  };

  /// \param mesh  its parts that are made of other cells have these cells' numbers
  /// \param parts one for each part of the mesh
  CellOrigins(std::shared_ptr<const Mesh> mesh, std::vector<Part> parts);

  /// \param cell through all parts of the mesh; there is no origin if it is not one of these
  CellOrigin Of(std::int64_t cell) const;

  /// The largest ids of points and cells of the data sets; -1 if there are none.
  vtkIdType LargestPoint() const;
  vtkIdType LargestCell() const;

private:
  std::shared_ptr<const Mesh> OfCells;
  std::vector<Part> Parts;
};

}

#endif
