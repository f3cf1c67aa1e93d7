// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/VolumePlace.h"

#include "Input/MatrixFromVtk.h"

#include <vtkVolume.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace TemporalCoherence
{
namespace
{

/// A transform with a smaller Flatness() counts as singular.
constexpr double FlattestBox = 1e-12;

/// The length of an edge, also if its square overflows or underflows.
double LengthOf(const glm::dvec3& edge)
{
  const double largest = std::max({ std::abs(edge.x), std::abs(edge.y), std::abs(edge.z) });
  return largest > 0.0 ? largest * glm::length(edge / largest) : 0.0;
}

/// Volume of the transformed unit box, divided by the volume of a rectangular box with equal edges;
/// 0 if the matrix is singular.
double Flatness(const glm::dmat4& matrix)
{
  glm::dmat3 m(matrix);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = LengthOf(m[axis]);
    if (!(length > 0.0))
    {
      return 0.0;
    }
    m[axis] /= length;
  }
  const double share = std::abs(glm::determinant(m));
  return std::isfinite(share) ? share : 0.0;
}

/// False if the volume of the transformed unit box is beyond the range of double precision.
bool HasInverse(const glm::dmat4& matrix)
{
  constexpr double most = 300.0; // as a power of ten
  double volume = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    volume += std::log10(LengthOf(glm::dvec3(matrix[axis])));
  }
  return std::abs(volume) <= most;
}

}

bool IsFinite(const glm::dmat4& matrix)
{
  for (int i = 0; i < 16; ++i)
  {
    if (!std::isfinite(matrix[i / 4][i % 4]))
    {
      return false;
    }
  }
  return true;
}

bool IsFlat(const glm::dmat4& matrix)
{
  return Flatness(matrix) < FlattestBox;
}

bool PlaceVolume(vtkVolume* volume, IndexTransform& transform, std::string& error)
{
  volume->ComputeMatrix();
  vtkMatrix4x4* matrix = volume->GetMatrix();
  const glm::dmat4 volumeMatrix = MatrixFromVtk(matrix);
  transform.WorldFromIndex = volumeMatrix * transform.WorldFromIndex;

  // This matrix includes the user matrix.
  const glm::dvec3 scale(
    glm::length(volumeMatrix[0]), glm::length(volumeMatrix[1]), glm::length(volumeMatrix[2]));
  const double* last = matrix->GetData() + 12;
  std::ostringstream what;
  if (!IsFinite(volumeMatrix) || !IsFinite(transform.WorldFromIndex))
  {
    what << "The transform of the volume is not finite (its scale is " << scale[0] << ", "
         << scale[1] << ", " << scale[2]
         << "); give it a position, orientation, scale and user matrix of finite numbers.";
  }
  else if (last[0] != 0.0 || last[1] != 0.0 || last[2] != 0.0 || last[3] != 1.0)
  {
    what << "The last row of the volume's matrix is (" << last[0] << ", " << last[1] << ", "
         << last[2] << ", " << last[3]
         << "), a projection; give it a user matrix whose last row is (0, 0, 0, 1).";
  }
  else if (IsFlat(transform.WorldFromIndex))
  {
    what << "The transform of the volume is singular (its scale is " << scale[0] << ", " << scale[1]
         << ", " << scale[2] << "); give it a scale other than 0 and an invertible user matrix.";
  }
  else if (!HasInverse(transform.WorldFromIndex))
  {
    const glm::dmat4& world = transform.WorldFromIndex;
    what << "The cells of the input have sides of about " << LengthOf(glm::dvec3(world[0])) << ", "
         << LengthOf(glm::dvec3(world[1])) << " and " << LengthOf(glm::dvec3(world[2]))
         << " in the world, which is beyond double precision; scale the input to lengths between "
            "1e-100 and 1e100.";
  }
  error = what.str();
  if (!error.empty())
  {
    return false;
  }
  transform.IndexFromWorld = glm::inverse(transform.WorldFromIndex);
  return true;
}

}
