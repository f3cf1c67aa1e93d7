// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FieldFromImage.h"

#include "MatrixFromVtk.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkVolume.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace TemporalCoherence
{
namespace
{

/// A transform is singular if it flattens a unit box to less than this share of the volume of one
/// with the same edges.
constexpr double FlattestBox = 1e-12;

template <typename T>
constexpr ScalarType ScalarTypeOf()
{
  if constexpr (std::is_floating_point_v<T>)
  {
    return sizeof(T) == 4 ? ScalarType::Float32 : ScalarType::Float64;
  }
  else if constexpr (std::is_signed_v<T>)
  {
    return sizeof(T) == 1 ? ScalarType::Int8
      : sizeof(T) == 2    ? ScalarType::Int16
      : sizeof(T) == 4    ? ScalarType::Int32
                          : ScalarType::Int64;
  }
  else
  {
    return sizeof(T) == 1 ? ScalarType::UInt8
      : sizeof(T) == 2    ? ScalarType::UInt16
      : sizeof(T) == 4    ? ScalarType::UInt32
                          : ScalarType::UInt64;
  }
}

/// First sample of a component and the step to the next tuple; false if it cannot be seen in place.
template <typename T>
bool FindSamples(vtkDataArray* array, int component, const void*& samples, std::int64_t& step)
{
  if (auto* perComponent = vtkSOADataArrayTemplate<T>::FastDownCast(array))
  {
    samples = perComponent->GetComponentArrayPointer(component);
    step = 1;
    return true;
  }
  if (array->HasStandardMemoryLayout())
  {
    samples = static_cast<const T*>(array->GetVoidPointer(0)) + component;
    step = array->GetNumberOfComponents();
    return true;
  }
  return false;
}

bool FindSamples(
  vtkDataArray* array, int component, ScalarType& type, const void*& samples, std::int64_t& step)
{
  switch (array->GetDataType())
  {
    vtkTemplateMacro(type = ScalarTypeOf<VTK_TT>();
                     return FindSamples<VTK_TT>(array, component, samples, step));
    default:
      return false;
  }
}

std::string NameOf(vtkDataArray* array)
{
  const char* name = array->GetName();
  return name ? "'" + std::string(name) + "'" : std::string("(unnamed)");
}

/// Share of the volume that a matrix leaves of a box with the same edges; 0 if it is singular.
double Flatness(const glm::dmat4& matrix)
{
  const glm::dmat3 m(matrix);
  for (int i = 0; i < 16; ++i)
  {
    if (!std::isfinite(matrix[i / 4][i % 4]))
    {
      return 0.0;
    }
  }
  const double edges = glm::length(m[0]) * glm::length(m[1]) * glm::length(m[2]);
  const double share = edges > 0.0 ? std::abs(glm::determinant(m)) / edges : 0.0;
  return std::isfinite(share) ? share : 0.0;
}

}

bool MakeField(
  vtkImageData* image, vtkDataArray* array, int component, Field& field, std::string& error)
{
  std::ostringstream what;
  int dimensions[3];
  image->GetDimensions(dimensions);
  const vtkIdType points = image->GetNumberOfPoints();
  field = Field();
  if (component < 0 || component >= array->GetNumberOfComponents())
  {
    what << "VectorComponent is " << component << ", but array " << NameOf(array) << " has "
         << array->GetNumberOfComponents() << " component(s); set one from 0 to "
         << array->GetNumberOfComponents() - 1 << ".";
  }
  else if (array->GetNumberOfTuples() < points)
  {
    what << "Array " << NameOf(array) << " has " << array->GetNumberOfTuples()
         << " tuples, but the image has " << points << " points; give it one tuple for each point.";
  }
  else
  {
    std::int64_t step = 1;
    if (FindSamples(array, component, field.Type, field.Samples, step))
    {
      field.Dimensions = glm::ivec3(dimensions[0], dimensions[1], dimensions[2]);
      field.Strides = glm::i64vec3(step, step * dimensions[0],
        step * dimensions[0] * static_cast<std::int64_t>(dimensions[1]));
      field.Stamp = std::max(image->GetMTime(), array->GetMTime());
      return true;
    }
    what
      << "Array " << NameOf(array) << " is a " << array->GetClassName()
      << ", whose samples cannot be read in place; copy it into an array of numbers, for example "
         "with vtkFloatArray::DeepCopy or vtkImageCast.";
  }
  error = what.str();
  return false;
}

bool MakePlacement(vtkImageData* image, vtkVolume* volume, Placement& placement, std::string& error)
{
  const int* extent = image->GetExtent();
  glm::dmat4 toFirst(1.0);
  toFirst[3] = glm::dvec4(extent[0], extent[2], extent[4], 1.0);
  const glm::dmat4 physicalFromIndex = MatrixFromVtk(image->GetIndexToPhysicalMatrix()) * toFirst;

  std::ostringstream what;
  if (Flatness(physicalFromIndex) < FlattestBox)
  {
    const double* spacing = image->GetSpacing();
    what
      << "The image's spacing (" << spacing[0] << ", " << spacing[1] << ", " << spacing[2]
      << ") or its direction matrix flattens it; set a spacing other than 0 along every axis and "
         "an invertible direction matrix.";
    error = what.str();
    return false;
  }

  volume->ComputeMatrix();
  placement.WorldFromIndex = MatrixFromVtk(volume->GetMatrix()) * physicalFromIndex;
  if (Flatness(placement.WorldFromIndex) < FlattestBox)
  {
    const double* scale = volume->GetScale();
    what << "The transform of the volume is singular (its scale is " << scale[0] << ", " << scale[1]
         << ", " << scale[2] << "); give it a scale other than 0 and an invertible user matrix.";
    error = what.str();
    return false;
  }
  placement.IndexFromWorld = glm::inverse(placement.WorldFromIndex);
  return true;
}

ImageAxes AxesOf(vtkImageData* image)
{
  const int* extent = image->GetExtent();
  ImageAxes axes;
  for (int axis = 0; axis < 3; ++axis)
  {
    axes.Step[axis] = image->GetSpacing()[axis];
    axes.First[axis] = image->GetOrigin()[axis] + extent[2 * axis] * axes.Step[axis];
  }
  return axes;
}

}
