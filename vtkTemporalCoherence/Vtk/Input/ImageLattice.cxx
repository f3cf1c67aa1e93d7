// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/ImageLattice.h"

#include <vtkImageData.h>
#include <vtkMatrix3x3.h>

#include <sstream>

namespace TemporalCoherence
{
namespace
{

/// Largest distance of points from lattice points, in steps.
constexpr double LargestMiss = 1e-6;

/// Largest distance between images, in steps: beyond, indices do not fit into an extent.
constexpr double LargestShift = 1e9;

glm::dvec3 SpacingOf(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  return { spacing[0], spacing[1], spacing[2] };
}

glm::dvec3 OriginOf(vtkImageData* image)
{
  const double* origin = image->GetOrigin();
  return { origin[0], origin[1], origin[2] };
}

/// Columns are the directions of the image's axes.
glm::dmat3 DirectionOf(vtkImageData* image)
{
  glm::dmat3 direction;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      direction[column][row] = image->GetDirectionMatrix()->GetElement(row, column);
    }
  }
  return direction;
}

std::string ToString(const glm::dvec3& v)
{
  std::ostringstream text;
  text.precision(10);
  text << '(' << v.x << ", " << v.y << ", " << v.z << ')';
  return text.str();
}

/// True if equal steps in two images reach the same points, up to the last one.
bool HaveSameSteps(const glm::dmat3& a, const glm::dmat3& b, vtkImageData* image)
{
  const int* dimensions = image->GetDimensions();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double miss = glm::length(a[axis] - b[axis]) * dimensions[axis];
    if (!(miss <= LargestMiss * glm::length(a[axis])))
    {
      return false;
    }
  }
  return true;
}

}

bool PlaceOnLattice(vtkImageData* lattice, vtkImageData* image, LatticeBox& place, std::string& why)
{
  glm::i64vec3 shift(0);
  if (image != lattice)
  {
    const glm::dvec3 spacing = SpacingOf(lattice), other = SpacingOf(image);
    glm::dmat3 steps = DirectionOf(lattice), otherSteps = DirectionOf(image);
    for (int axis = 0; axis < 3; ++axis)
    {
      steps[axis] *= spacing[axis];
      otherSteps[axis] *= other[axis];
    }
    if (!HaveSameSteps(steps, otherSteps, image))
    {
      why = "its spacing " + ToString(other) + " or its direction is not that of the others, " +
        ToString(spacing);
      return false;
    }
    const glm::dvec3 apart = glm::inverse(steps) * (OriginOf(image) - OriginOf(lattice));
    const glm::dvec3 miss = glm::abs(apart - glm::round(apart));
    if (!(glm::all(glm::lessThanEqual(miss, glm::dvec3(LargestMiss))) &&
          glm::all(glm::lessThan(glm::abs(apart), glm::dvec3(LargestShift)))))
    {
      why = "its origin is not whole steps from that of the others, but " + ToString(apart);
      return false;
    }
    shift = glm::i64vec3(glm::round(apart));
  }
  const int* extent = image->GetExtent();
  place.First = shift + glm::i64vec3(extent[0], extent[2], extent[4]);
  place.Last = shift + glm::i64vec3(extent[1], extent[3], extent[5]);
  return true;
}

}
