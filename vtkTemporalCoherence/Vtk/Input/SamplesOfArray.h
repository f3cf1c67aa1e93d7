// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SamplesOfArray_h
#define TemporalCoherence_SamplesOfArray_h

#include "Input/ScalarChoice.h"
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
/// arrays of components and, since VTK 9.7, in vtkStridedArray (9.6 hides the address of its
/// samples). VTK computes the samples of other arrays.
bool AreInPlace(vtkDataArray* array);

/// \pre AreInPlace(array), and the array has the component
ArraySamples SamplesOf(vtkDataArray* array, int component);

/// A copy with equal numbers that AreInPlace. A line in the log reports it.
/// \param type VTK's number for the type of the copy; negative: the array's own type, or unsigned
///             characters for bits
/// \throws std::bad_alloc
vtkSmartPointer<vtkDataArray> CopyInPlace(vtkDataArray* array, int type = -1);

/// Provides arrays in place. Keeps copies of other arrays until the originals change.
class ArraysInPlace
{
public:
  /// The array itself if it AreInPlace, otherwise a copy. Null for null.
  /// \param time a later modification time from another object, if any
  /// \throws std::bad_alloc
  vtkDataArray* Of(vtkDataArray* array, vtkMTimeType time = 0);

  /// Drop the copies that were not requested since the last call.
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

/// \param error receives the mistake and its remedy
/// \return false if the array lacks a component that the user chose
bool HasComponent(vtkDataArray* array, int component, std::string& error);

/// Check that an array has the component that is to give colours. Lengths of vectors need none.
/// \param error receives the mistake and its remedy
bool HasComponent(vtkDataArray* array, const ArrayChoice& choice, std::string& error);

/// The number of cells or points of an image. If it overflows, which VTK does not notice, the
/// largest number, so that no array has enough tuples.
std::int64_t CountSamples(vtkImageData* image, bool onCells);

/// The points or cells of a data set, to which the values of an array belong.
struct ArrayPlaces
{
  std::string Owner; ///< name of the data set in messages
  bool AreCells = false;
  std::int64_t Count = 0;
};

/// True if an array has one tuple for each place. With more tuples than cells, the array belongs to
/// other cells. With more tuples than points, VTK draws the first ones.
bool HasOneForEach(vtkDataArray* array, const ArrayPlaces& places);

/// Check that an array has one tuple for each place, as HasOneForEach counts.
/// \param error receives the mistake and its remedy
/// \return false if their number is wrong
bool CheckTuples(vtkDataArray* array, const ArrayPlaces& places, std::string& error);

/// The name of an array in quotation marks, for messages.
std::string NameOf(vtkDataArray* array);

}

#endif
