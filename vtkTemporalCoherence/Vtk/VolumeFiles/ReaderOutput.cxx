// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/ReaderOutput.h"

#include "VolumeFiles/ReaderErrors.h"
#include "VolumeFiles/ReaderFiles.h"
#include "VolumeFiles/VtkTypes.h"

#include <vtkAlgorithm.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

namespace TemporalCoherence
{

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// The array of samples; null with a sentence if the image lacks it.
vtkDataArray* FindArray(vtkAlgorithm* reader, const std::string& name, std::string& error)
{
  auto* const image = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
  vtkPointData* const points = image->GetPointData();
  vtkDataArray* const first = points->GetScalars() ? points->GetScalars() : points->GetArray(0);
  vtkDataArray* const array = name.empty() ? first : points->GetArray(name.c_str());
  if (!array)
  {
    error = ReaderText(reader) + "gives no array " + (name.empty() ? "" : "'" + name + "' ") +
      "of points; choose another one, or enable it in the reader.";
    return nullptr;
  }
  if (array->GetNumberOfComponents() != 1)
  {
    error = ReaderText(reader) + "gives an array '" + (array->GetName() ? array->GetName() : "") +
      "' of " + std::to_string(array->GetNumberOfComponents()) +
      " components, but a volume has one; choose another array, or extract a component.";
    return nullptr;
  }
  return array;
}

/// Take the array that the reader gave.
bool TakeSamples(
  vtkAlgorithm* reader, const std::string& arrayName, ReadSamples& samples, std::string& error)
{
  samples.Array = FindArray(reader, arrayName, error);
  if (!samples.Array)
  {
    return false;
  }
  auto* const image = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
  image->GetExtent(samples.Part.Ends.data());
  const glm::i64vec3 size(samples.Part.Size());
  const std::int64_t count = size.x * size.y * size.z;
  if (samples.Array->GetNumberOfTuples() < count)
  {
    error = ReaderText(reader) + "gives only " +
      std::to_string(samples.Array->GetNumberOfTuples()) + " of " + std::to_string(count) +
      " samples; get the file again, or choose another array.";
    return false;
  }
  const std::optional<ScalarType> type = TypeOfVtk(samples.Array->GetDataType());
  if (!type)
  {
    error = ReaderText(reader) + "gives samples of type " + samples.Array->GetDataTypeAsString() +
      ", which are no numbers; choose another array.";
    return false;
  }
  if (!samples.Array->HasStandardMemoryLayout())
  {
    const auto copy = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(samples.Array->GetDataType()));
    copy->DeepCopy(samples.Array);
    samples.Array = copy;
  }
  samples.First = samples.Array->GetVoidPointer(0);
  samples.Type = *type;
  return true;
}

}

std::string ReaderText(vtkAlgorithm* reader)
{
  const std::vector<std::string> files = FilesOf(reader);
  return std::string("Reader ") + reader->GetClassName() +
    (files.empty() ? " " : " of file '" + files.front() + "' ");
}

bool UpdateInformation(
  vtkAlgorithm* reader, ReaderErrors& errors, Extent& whole, std::string& error)
{
  errors.Clear();
  reader->Modified(); // forgets earlier errors, and looks at the file again
  reader->UpdateInformation();
  if (!errors.Text().empty())
  {
    error = ReaderText(reader) + "fails: " + errors.Text() + '.';
    return false;
  }
  vtkInformation* const info =
    reader->GetNumberOfOutputPorts() > 0 ? reader->GetOutputInformation(0) : nullptr;
  if (!info || !vtkImageData::SafeDownCast(reader->GetOutputDataObject(0)) ||
    !info->Has(Pipeline::WHOLE_EXTENT()))
  {
    error = ReaderText(reader) + "gives no image; choose a reader of images.";
    return false;
  }
  info->Get(Pipeline::WHOLE_EXTENT(), whole.Ends.data());
  const glm::dvec3 size = whole.Size();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (size[axis] < 1.0 || size[axis] > std::numeric_limits<int>::max())
    {
      error =
        ReaderText(reader) + "gives an empty image; check the file and the reader's settings.";
      return false;
    }
  }
  return true;
}

bool ReadPart(vtkAlgorithm* reader, ReaderErrors& errors, const Extent& asked,
  const std::string& arrayName, ReadSamples& samples, std::string& error)
{
  errors.Clear();
  if (!CheckSlices(reader, asked.Ends[4], asked.Ends[5], error))
  {
    return false;
  }
  if (reader->IsA("vtkTIFFReader"))
  {
    // This reader repeats the first page unless it reads the information before each page.
    reader->Modified();
  }
  const bool isDone = reader->UpdateExtent(asked.Ends.data()) != 0;
  if (!isDone || !errors.Text().empty())
  {
    const std::string text = errors.Text();
    error = ReaderText(reader) + "fails: " + (text.empty() ? "unknown error" : text) + '.';
    reader->Modified(); // forgets the error when it reads the next part
    return false;
  }
  if (!TakeSamples(reader, arrayName, samples, error))
  {
    return false;
  }
  if (!samples.Part.Contains(asked))
  {
    error =
      ReaderText(reader) + "gives less of the volume than it was asked for; get the file again.";
    return false;
  }
  return true;
}

void CopyPart(const ReadSamples& samples, const Extent& part, const glm::ivec3& room, void* to)
{
  const std::size_t bytes = SizeOf(samples.Type);
  const glm::i64vec3 given(samples.Part.Size());
  const glm::i64vec3 size(part.Size());
  const glm::i64vec3 offset(part.First() - samples.Part.First());
  const auto* const from = static_cast<const char*>(samples.First);
  const std::size_t row = bytes * static_cast<std::size_t>(size.x);
  for (std::int64_t z = 0; z < size.z; ++z)
  {
    for (std::int64_t y = 0; y < size.y; ++y)
    {
      const std::int64_t first = ((offset.z + z) * given.y + offset.y + y) * given.x + offset.x;
      const std::int64_t target = (z * room.y + y) * room.x;
      std::memcpy(static_cast<char*>(to) + bytes * static_cast<std::size_t>(target),
        from + bytes * static_cast<std::size_t>(first), row);
    }
  }
}

}
