// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/FieldNormals.h"

#include <cmath>

namespace TemporalCoherence
{

glm::dvec3 FieldNormals::FaceNormal(const Field& field, const CapPoint& cap, double& nearest) const
{
  glm::dvec3 normal(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double face = cap.Direction[axis] > 0.0 ? 0.0 : field.Dimensions[axis] - 1;
    const double distance = std::abs(cap.At[axis] - face);
    if (cap.Direction[axis] != 0.0 && distance < nearest)
    {
      nearest = distance;
      normal = glm::dvec3(0.0);
      normal[axis] = cap.Direction[axis] > 0.0 ? -1.0 : 1.0;
    }
  }
  return normal;
}

}
