// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SamplesOfArray_h
#define TemporalCoherence_SamplesOfArray_h

#include "Scene/Field.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <cstdint>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The samples of one component of an array, in place.
struct ArraySamples
{
  const void* First = nullptr;
  ScalarType Type = ScalarType::UInt8;
  std::int64_t Step = 1; ///< scalars from one tuple to the next
};

/// \pre the array has the component
/// \param error gets what is wrong and what to do about it
/// \return false if the samples are not equally spaced in memory
bool FindSamples(vtkDataArray* array, int component, ArraySamples& samples, std::string& error);

/// \param error gets what is wrong and what to do about it
/// \return false if the array lacks a component that the user chose
bool HasComponent(vtkDataArray* array, int component, std::string& error);

/// The number of cells or points of an image. If it overflows, which VTK does not notice, the
/// largest number, so that no array has enough tuples.
std::int64_t CountSamples(vtkImageData* image, bool onCells);

/// The name of an array in quotation marks, for messages.
std::string NameOf(vtkDataArray* array);

}

#endif
