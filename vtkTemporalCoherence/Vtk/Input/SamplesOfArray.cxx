// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/SamplesOfArray.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkLogger.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkVersionMacros.h>
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0)
#include <vtkStridedArray.h>
#endif

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
/// VTK 9.3 on many arrays do, and reveal it only by an error.
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
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0)
  auto* const strided = vtkStridedArray<T>::FastDownCast(array);
  if (const auto backend = strided ? strided->GetBackend() : nullptr)
  {
    samples.First = backend->GetBuffer() + backend->GetOffset() + component;
    samples.Step = backend->GetStride();
    return true;
  }
#endif
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

bool AreInPlace(vtkDataArray* array)
{
  ArraySamples samples;
  return FindSamplesOfAnyType(array, 0, samples);
}

ArraySamples SamplesOf(vtkDataArray* array, int component)
{
  ArraySamples samples;
  FindSamplesOfAnyType(array, component, samples);
  return samples;
}

vtkSmartPointer<vtkDataArray> CopyInPlace(vtkDataArray* array, int type)
{
  const int own = array->GetDataType() == VTK_BIT ? VTK_UNSIGNED_CHAR : array->GetDataType();
  const auto copy =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type < 0 ? own : type));
  copy->DeepCopy(array);
  vtkLog(INFO, << "Array " << NameOf(array) << " is copied to be read, as its "
               << array->GetNumberOfTuples() << " tuples do not lie in memory.");
  return copy;
}

std::size_t ArraysInPlace::MemoryInBytes() const
{
  std::size_t bytes = 0;
  for (const Kept& kept : this->Copies)
  {
    bytes += static_cast<std::size_t>(kept.Copy->GetActualMemorySize()) << 10;
  }
  return bytes;
}

vtkDataArray* ArraysInPlace::Of(vtkDataArray* array, vtkMTimeType time)
{
  if (!array || AreInPlace(array))
  {
    return array;
  }
  const vtkMTimeType now = std::max(time, array->GetMTime());
  for (Kept& kept : this->Copies)
  {
    if (kept.Of == array && kept.Time == now)
    {
      kept.IsUsed = true;
      return kept.Copy;
    }
  }
  this->Copies.push_back({ array, now, CopyInPlace(array) });
  return this->Copies.back().Copy;
}

void ArraysInPlace::DropUnused()
{
  this->Copies.erase(std::remove_if(this->Copies.begin(), this->Copies.end(),
                       [](const Kept& kept) { return !kept.IsUsed; }),
    this->Copies.end());
  for (Kept& kept : this->Copies)
  {
    kept.IsUsed = false;
  }
}

namespace
{

/// \param setting its name
bool HasComponent(
  vtkDataArray* array, int component, const char* setting, const char* other, std::string& error)
{
  const int components = array->GetNumberOfComponents();
  if (component >= 0 && component < components)
  {
    return true;
  }
  error = std::string(setting) + " is " + std::to_string(component) + ", but array " +
    NameOf(array) + " has " + std::to_string(components) + " component(s); set one from 0 to " +
    std::to_string(components - 1) + other + ".";
  return false;
}

}

bool HasComponent(vtkDataArray* array, int component, std::string& error)
{
  return HasComponent(array, component, "VectorComponent", "", error);
}

bool HasComponent(vtkDataArray* array, const ArrayChoice& choice, std::string& error)
{
  return choice.Component < 0 ||
    HasComponent(
      array, choice.Component, "ColorArrayComponent", ", or -1 for the length of vectors", error);
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

bool HasOneForEach(vtkDataArray* array, const ArrayPlaces& places)
{
  const std::int64_t tuples = array->GetNumberOfTuples();
  return places.AreCells ? tuples == places.Count : tuples >= places.Count;
}

bool CheckTuples(vtkDataArray* array, const ArrayPlaces& places, std::string& error)
{
  if (HasOneForEach(array, places))
  {
    return true;
  }
  const std::string place = places.AreCells ? "cell" : "point";
  error = places.Owner + " has an array " + NameOf(array) + " of " +
    std::to_string(array->GetNumberOfTuples()) + " tuples, but " + std::to_string(places.Count) +
    ' ' + place + "s; give it one tuple for each " + place + '.';
  return false;
}

std::string NameOf(vtkDataArray* array)
{
  const char* name = array->GetName();
  return name ? "'" + std::string(name) + "'" : std::string("(unnamed)");
}

}
