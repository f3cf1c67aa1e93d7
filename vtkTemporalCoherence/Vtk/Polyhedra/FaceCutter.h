// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FaceCutter_h
#define TemporalCoherence_FaceCutter_h

#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolygon.h>
#include <vtkType.h>

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

/// Cuts concave faces into triangles between their own points.
///
/// The triangles depend on the numbers and places of the points alone, not on which point the face
/// begins with or on its direction. So both cells that share a face cut it in the same way.
class FaceCutter
{
public:
  /// Places of points in the list of a face's points, ascending.
  using Triangle = std::array<std::size_t, 3>;

  /// \param face   the numbers of its points, in order around it
  /// \param places of these points
  /// \return no triangles for a triangle, a convex quadrilateral, and a polygon whose edges are all
  /// visible from the mean of its points; and for a face that crosses itself
  std::vector<Triangle> Cut(
    const std::vector<vtkIdType>& face, const std::vector<glm::dvec3>& places);

private:
  std::vector<Triangle> CutEars(const std::vector<glm::dvec3>& places);

  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Ears;
};

}

#endif
