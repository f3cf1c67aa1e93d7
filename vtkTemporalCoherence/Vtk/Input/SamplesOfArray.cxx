// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/SamplesOfArray.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkSOADataArrayTemplate.h>

#include <algorithm>
#include <limits>

namespace TemporalCoherence
{
namespace
{

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

/// The samples of a component in a buffer of its own; null if the array stores whole tuples. From
/// VTK 9.3 on many arrays do, and tell it only by an error.
template <typename T>
const T* OwnComponent(vtkSOADataArrayTemplate<T>* array, int component)
{
  const int showsErrors = vtkObject::GetGlobalWarningDisplay();
  vtkObject::GlobalWarningDisplayOff();
  const T* samples = array->GetComponentArrayPointer(component);
  vtkObject::SetGlobalWarningDisplay(showsErrors);
  return samples;
}

template <typename T>
bool FindTypedSamples(vtkDataArray* array, int component, ArraySamples& samples)
{
  samples.Type = ScalarTypeOf<T>();
  if (auto* perComponent = vtkSOADataArrayTemplate<T>::FastDownCast(array))
  {
    samples.First = OwnComponent(perComponent, component);
    samples.Step = 1;
    if (samples.First == nullptr)
    {
      samples.First = static_cast<const T*>(array->GetVoidPointer(0)) + component;
      samples.Step = array->GetNumberOfComponents();
    }
    return true;
  }
  if (array->HasStandardMemoryLayout())
  {
    samples.First = static_cast<const T*>(array->GetVoidPointer(0)) + component;
    samples.Step = array->GetNumberOfComponents();
    return true;
  }
  return false;
}

bool FindSamplesOfAnyType(vtkDataArray* array, int component, ArraySamples& samples)
{
  switch (array->GetDataType())
  {
    vtkTemplateMacro(return FindTypedSamples<VTK_TT>(array, component, samples));
    default:
      return false;
  }
}

}

bool FindSamples(vtkDataArray* array, int component, ArraySamples& samples, std::string& error)
{
  if (FindSamplesOfAnyType(array, component, samples))
  {
    return true;
  }
  error = "Array " + NameOf(array) + " is a " + array->GetClassName() +
    ", whose samples cannot be read in place; copy it into an array of numbers, for example with "
    "vtkFloatArray::DeepCopy or vtkImageCast.";
  return false;
}

bool HasComponent(vtkDataArray* array, int component, std::string& error)
{
  const int components = array->GetNumberOfComponents();
  if (component >= 0 && component < components)
  {
    return true;
  }
  error = "VectorComponent is " + std::to_string(component) + ", but array " + NameOf(array) +
    " has " + std::to_string(components) + " component(s); set one from 0 to " +
    std::to_string(components - 1) + ".";
  return false;
}

std::int64_t CountSamples(vtkImageData* image, bool onCells)
{
  constexpr double most = 1e18;
  const int* extent = image->GetExtent();
  double points = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double along = static_cast<double>(extent[2 * axis + 1]) - extent[2 * axis] + 1.0;
    if (along > std::numeric_limits<int>::max())
    {
      return std::numeric_limits<std::int64_t>::max();
    }
    points *= std::max(along, 0.0);
  }
  if (points > most)
  {
    return std::numeric_limits<std::int64_t>::max();
  }
  return onCells ? image->GetNumberOfCells() : image->GetNumberOfPoints();
}

std::string NameOf(vtkDataArray* array)
{
  const char* name = array->GetName();
  return name ? "'" + std::string(name) + "'" : std::string("(unnamed)");
}

}
