// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PolyhedronCells_h
#define TemporalCoherence_PolyhedronCells_h

#include "Polyhedra/ClosedSurface.h"
#include "Polyhedra/ConeDivision.h"
#include "Polyhedra/FaceCutter.h"
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

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
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
/// The division of a face depends on this face alone, so neighbours share it. A triangle stays
/// whole, a convex quadrilateral is bilinear like a hexahedron's face, and a face with more points
/// becomes triangles around its middle, which has the mean of its points and of their values. A
/// concave face becomes triangles between its points.
class PolyhedronCells
{
public:
  PolyhedronCells(
    const GivenCells& given, const PointReader& reader, SharedPoints& shared, MadeCells& made);

  /// \pre the cell has such a type
  /// \return false on error
  bool Add(vtkIdType cell, std::string& error);

  /// Concave cells that are drawn beyond their faces, because no division was found.
  std::vector<vtkIdType> Overlapping;

  std::int64_t Searches = 0; ///< searches for a division, which may take long

private:
  using Face = GivenCells::Face;

  /// The surface of a cell. It numbers its own points: first the cell's points, then the middles of
  /// faces.
  struct Surface
  {
    std::vector<Face> Faces;
    std::vector<std::int32_t> Middles; ///< of faces; -1: the face has none
    Face Corners;                      ///< the points of the cell, ascending
    std::vector<PointValue> Points;
    std::vector<glm::dvec3> Places; ///< of these points
    std::vector<SurfacePart> Parts;

    std::size_t NumberOf(vtkIdType corner) const;
  };

  bool AddPolyhedron(vtkIdType cell, std::string& error);
  bool AddPrism(vtkIdType cell, std::string& error);
  void AddConvexSet(vtkIdType cell);

  const Surface& SurfaceOf(std::vector<Face> faces);
  void AddParts(const Face& face);
  bool HasConcaveFace(const std::vector<Face>& faces);
  void AddCones(const Surface& surface, vtkIdType cell);
  bool Divide(const Surface& surface, ConeDivision& division);
  void AddCone(const SurfacePart& base, std::int32_t apex, const std::vector<std::int32_t>& numbers,
    vtkIdType cell);

  std::vector<std::int32_t> NumbersOf(const Surface& surface);
  std::int32_t NumberOf(vtkIdType point);
  std::int32_t MiddleOf(const Face& face, const PointValue& middle);
  std::vector<PointValue> Read(const Face& points) const;

  GivenCells Given;
  vtkUnstructuredGrid* Grid;
  PointReader Reader;
  SharedPoints& Shared;
  MadeCells& Made;
  FaceCutter Cutter;
  DivisionWork Work;
  Surface Last; ///< a member to re-use its memory
  std::vector<std::int32_t> FaceNumbers;
  std::vector<PointValue> FacePoints;
  std::vector<glm::dvec3> FacePlaces;
  vtkNew<vtkOrderedTriangulator> Triangulator;
  vtkNew<vtkIdList> Ids;
  vtkNew<vtkPoints> Corners;
};

}

#endif
