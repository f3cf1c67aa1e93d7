// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SamplesOfArray_h
#define TemporalCoherence_SamplesOfArray_h

#include "Scene/Field.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <cstdint>
#include <string>
#include <vector>

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

/// True if the samples of each component are equally spaced in memory: in arrays of tuples, in
/// arrays of components and, since VTK 9.7, in vtkStridedArray (9.6 does not tell where its samples
/// lie). VTK computes the samples of other arrays.
bool AreInPlace(vtkDataArray* array);

/// \pre AreInPlace(array), and the array has the component
ArraySamples SamplesOf(vtkDataArray* array, int component);

/// A copy with the same numbers that AreInPlace. A line in the log tells of it.
/// \param type VTK's number for the type of the copy; negative: the array's own type, or unsigned
///             characters for bits
/// \throws std::bad_alloc
vtkSmartPointer<vtkDataArray> CopyInPlace(vtkDataArray* array, int type = -1);

/// Gives each array in place, and keeps copies of arrays that are not until these change.
class ArraysInPlace
{
public:
  /// The array itself if it AreInPlace, otherwise a copy. Null for null.
  /// \param time if others than the array tell that it may have changed
  /// \throws std::bad_alloc
  vtkDataArray* Of(vtkDataArray* array, vtkMTimeType time = 0);

  /// Drop the copies that nobody has asked for since the last call.
  void DropUnused();

  /// Bytes of the copies.
  std::size_t MemoryInBytes() const;

private:
  struct Kept
  {
    const vtkDataArray* Of = nullptr; // may dangle
    vtkMTimeType Time = 0;
    vtkSmartPointer<vtkDataArray> Copy;
    bool IsUsed = true;
  };
  std::vector<Kept> Copies;
};

/// \param error gets what is wrong and what to do about it
/// \return false if the array lacks a component that the user chose
bool HasComponent(vtkDataArray* array, int component, std::string& error);

/// The number of cells or points of an image. If it overflows, which VTK does not notice, the
/// largest number, so that no array has enough tuples.
std::int64_t CountSamples(vtkImageData* image, bool onCells);

/// The points or the cells of a data set, which an array has values of.
struct ArrayPlaces
{
  std::string Owner; ///< how messages call the data set
  bool AreCells = false;
  std::int64_t Count = 0;
};

/// True if an array has one tuple for each place. More tuples than cells belong to other cells; of
/// more tuples than points VTK draws the first ones.
bool HasOneForEach(vtkDataArray* array, const ArrayPlaces& places);

/// Check that an array has one tuple for each place, as HasOneForEach counts.
/// \param error gets what is wrong and what to do about it
/// \return false if it has not
bool CheckTuples(vtkDataArray* array, const ArrayPlaces& places, std::string& error);

/// The name of an array in quotation marks, for messages.
std::string NameOf(vtkDataArray* array);

}

#endif
