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

/// Samples of one component of an array, seen in place.
struct ArraySamples
{
  const void* First = nullptr;
  ScalarType Type = ScalarType::UInt8;
  std::int64_t Step = 1; ///< scalars from one tuple to the next
};

/// \pre the array has the component
/// \param error gets what is wrong and what to do about it
/// \return false if the samples do not lie in memory at equal steps
bool FindSamples(vtkDataArray* array, int component, ArraySamples& samples, std::string& error);

/// Cells or points of an image. Of an extent that claims more than can be counted, which VTK does
/// not notice, it is the largest number, so that no array has enough tuples.
std::int64_t CountSamples(vtkImageData* image, bool onCells);

/// The array's name in quotation marks, for errors.
std::string NameOf(vtkDataArray* array);

}

#endif
