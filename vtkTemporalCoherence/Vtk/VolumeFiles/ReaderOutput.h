// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ReaderOutput_h
#define TemporalCoherence_ReaderOutput_h

#include "Scene/ScalarType.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkSmartPointer.h>

#include <glm/glm.hpp>

#include <array>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkDataArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

class ReaderErrors;

/// The first and the last sample along x, y and z, both included, as in VTK.
struct Extent
{
  std::array<int, 6> Ends{ 0, -1, 0, -1, 0, -1 };

  glm::ivec3 First() const { return { this->Ends[0], this->Ends[2], this->Ends[4] }; }
  glm::ivec3 Last() const { return { this->Ends[1], this->Ends[3], this->Ends[5] }; }

  /// Samples along each axis.
  glm::dvec3 Size() const
  {
    return glm::dvec3(this->Last()) - glm::dvec3(this->First()) + glm::dvec3(1.0);
  }

  bool Contains(const Extent& other) const
  {
    return glm::all(glm::lessThanEqual(this->First(), other.First())) &&
      glm::all(glm::greaterThanEqual(this->Last(), other.Last()));
  }
};

/// Bring a reader's information up to date.
/// \param errors collects those of the reader
/// \param error receives what the reader reports
bool UpdateInformation(
  vtkAlgorithm* reader, ReaderErrors& errors, Extent& whole, std::string& error);

/// An array of samples of one component, and the part of the volume that it fills.
struct ReadSamples
{
  vtkSmartPointer<vtkDataArray> Array; ///< in memory without gaps
  const void* First = nullptr;
  ScalarType Type = ScalarType::UInt8;
  Extent Part;
};

/// Let a reader read a part of its volume.
/// \param errors    collects those of the reader
/// \param asked     part of the whole extent
/// \param arrayName name of an array of points; empty: the scalars, or the first array
/// \param samples   receives what the reader gives: this part or more
/// \param error     receives what is wrong, in one sentence
bool ReadPart(vtkAlgorithm* reader, ReaderErrors& errors, const Extent& asked,
  const std::string& arrayName, ReadSamples& samples, std::string& error);

/// Copy the samples of a part.
/// \param part    a part of that of the samples
/// \param room    samples along x, y and z between the first ones of rows and slices in memory
/// \param to      room for them
void CopyPart(const ReadSamples& samples, const Extent& part, const glm::ivec3& room, void* to);

/// "Reader vtkX of file 'name' ", the begin of messages.
std::string ReaderText(vtkAlgorithm* reader);

}

#endif
