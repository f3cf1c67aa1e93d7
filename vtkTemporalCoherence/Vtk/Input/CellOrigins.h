// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellOrigins_h
#define TemporalCoherence_CellOrigins_h

#include <vtkDataSet.h>
#include <vtkType.h>
#include <vtkWeakPointer.h>

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

struct Mesh;

/// A cell of the data that a mapper draws.
struct CellOrigin
{
  vtkDataSet* Data = nullptr; ///< null if it was deleted
  unsigned int Block = 0;     ///< flat index in the composite data set; 0 if there is none
  vtkIdType Cell = -1;        ///< -1: no cell
};

/// The point of a cell nearest to a place in the data's coordinates; -1 without a cell.
vtkIdType NearestPointOf(const CellOrigin& cell, const glm::dvec3& place);

/// Maps the cells of a mesh to the cells of data sets from which they were made. Immutable, and
/// shared by frames.
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

  /// \param mesh  parts of divided cells hold the numbers of the original cells
  /// \param parts one for each part of the mesh
  CellOrigins(std::shared_ptr<const Mesh> mesh, std::vector<Part> parts);

  /// \param cell counted through all parts of the mesh; other numbers have no origin
  CellOrigin Of(std::int64_t cell) const;

  /// The data set of a part of the mesh; no cell of it.
  CellOrigin OfPart(std::size_t part) const
  {
    return { this->Parts[part].Data, this->Parts[part].Block, -1 };
  }

  /// The largest ids of points and cells of the data sets; -1 if there are none.
  vtkIdType LargestPoint() const;
  vtkIdType LargestCell() const;

private:
  std::shared_ptr<const Mesh> OfCells;
  std::vector<Part> Parts;
};

}

#endif
