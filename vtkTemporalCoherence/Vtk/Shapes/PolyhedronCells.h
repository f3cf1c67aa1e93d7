// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PolyhedronCells_h
#define TemporalCoherence_PolyhedronCells_h

#include "Shapes/GivenCells.h"
#include "Shapes/MadeCells.h"
#include "Shapes/PointReader.h"
#include "Shapes/SharedPoints.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkOrderedTriangulator.h>
#include <vtkPoints.h>
#include <vtkType.h>

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkUnstructuredGrid;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// True for polyhedra, prisms over pentagons and hexagons, and convex sets of points.
bool IsPolyhedron(int type);

/// Makes linear cells of cells with many faces.
///
/// All that neighbours share is made of a face alone: a triangle stays one, a quadrilateral is
/// bilinear, as that of a hexahedron, and a face with more points becomes triangles around a point
/// in its middle, which has the mean of its points and of their values.
class PolyhedronCells
{
public:
  PolyhedronCells(
    const GivenCells& given, const PointReader& reader, SharedPoints& shared, MadeCells& made);

  /// \pre the cell has such a type
  /// \return false on error
  bool Add(vtkIdType cell, std::string& error);

private:
  using Face = GivenCells::Face;

  bool AddPolyhedron(vtkIdType cell, std::string& error);
  bool AddPrism(vtkIdType cell, std::string& error);
  void AddConvexSet(vtkIdType cell);
  void AddConeOver(const Face& face, std::int32_t apex, vtkIdType cell);

  std::int32_t NumberOf(vtkIdType point);
  std::int32_t MiddleOf(const Face& face);
  PointValue MeanOf(const Face& points) const;

  GivenCells Given;
  vtkUnstructuredGrid* Grid;
  PointReader Reader;
  SharedPoints& Shared;
  MadeCells& Made;
  vtkNew<vtkOrderedTriangulator> Triangulator;
  vtkNew<vtkIdList> Ids;
  vtkNew<vtkPoints> Corners;
};

}

#endif
