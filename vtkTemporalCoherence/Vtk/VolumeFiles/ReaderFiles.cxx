// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/ReaderFiles.h"

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageReader2.h>
#include <vtkInformation.h>
#include <vtkMRCReader.h>
#include <vtkStringArray.h>
#include <vtkType.h>

#include <filesystem>
#include <sstream>

namespace TemporalCoherence
{

namespace
{

/// The files of slices, or the one file of a volume.
std::vector<std::string> FilesOfImages(vtkImageReader2* reader)
{
  std::vector<std::string> files;
  if (vtkStringArray* const names = reader->GetFileNames())
  {
    for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
    {
      files.push_back(names->GetValue(i));
    }
    return files;
  }
  if (reader->GetFileName())
  {
    return { reader->GetFileName() };
  }
  const int* const extent = reader->GetDataExtent();
  const int last = reader->GetFileDimensionality() == 2 ? extent[5] : extent[4];
  for (int slice = extent[4]; slice <= last && reader->GetFilePattern(); ++slice)
  {
    reader->ComputeInternalFileName(slice);
    if (reader->GetInternalFileName())
    {
      files.push_back(reader->GetInternalFileName());
    }
  }
  return files;
}

/// What a reader of any class prints as its file names.
std::vector<std::string> PrintedFiles(vtkAlgorithm* reader)
{
  std::vector<std::string> files;
  std::ostringstream printed;
  reader->Print(printed);
  std::istringstream lines(printed.str());
  const std::string key = "FileName: ";
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin != std::string::npos && line.compare(begin, key.size(), key) == 0)
    {
      files.push_back(line.substr(begin + key.size()));
    }
  }
  return files;
}

/// Bytes of a file or, if it is a folder, 1; negative if it is missing.
double LengthOf(const std::string& file)
{
  const std::filesystem::path path = std::filesystem::u8path(file);
  std::error_code failure;
  if (std::filesystem::is_directory(path, failure))
  {
    return 1.0;
  }
  const auto size = std::filesystem::file_size(path, failure);
  return failure ? -1.0 : static_cast<double>(size);
}

/// Bytes of uncompressed samples.
double BytesOf(vtkAlgorithm* reader, const int extent[6], bool isSlice)
{
  vtkInformation* const scalars =
    vtkDataObject::GetActiveFieldInformation(reader->GetOutputInformation(0),
      vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  if (!scalars)
  {
    return 0.0;
  }
  double bytes = vtkDataArray::GetDataTypeSize(scalars->Get(vtkDataObject::FIELD_ARRAY_TYPE()));
  bytes *= scalars->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS());
  for (int axis = 0; axis < (isSlice ? 2 : 3); ++axis)
  {
    bytes *= static_cast<double>(extent[2 * axis + 1]) - extent[2 * axis] + 1.0;
  }
  return bytes;
}

}

std::vector<std::string> FilesOf(vtkAlgorithm* reader)
{
  if (auto* const images = vtkImageReader2::SafeDownCast(reader))
  {
    return FilesOfImages(images);
  }
  if (auto* const mrc = vtkMRCReader::SafeDownCast(reader))
  {
    return mrc->GetFileName() ? std::vector<std::string>{ mrc->GetFileName() }
                              : std::vector<std::string>();
  }
  return PrintedFiles(reader);
}

bool CheckFiles(vtkAlgorithm* reader, const int extent[6], std::string& error)
{
  const std::string name = reader->GetClassName();
  auto* const images = vtkImageReader2::SafeDownCast(reader);
  const bool isMrc = name == "vtkMRCReader";
  if (!images && !isMrc)
  {
    return true;
  }
  const bool isRaw = images && (name == "vtkImageReader2" || name == "vtkImageReader");
  constexpr double headerOfMrc = 1024.0;
  const double samples = isRaw
    ? BytesOf(reader, images->GetDataExtent(), images->GetFileDimensionality() == 2)
    : isMrc ? BytesOf(reader, extent, false) + headerOfMrc
            : 1.0;
  for (const std::string& file : FilesOf(reader))
  {
    const double size = LengthOf(file);
    double expected = samples;
    if (isRaw && size >= samples)
    {
      // Without a header of its own, the reader finds one of the length that is left over.
      expected += static_cast<double>(images->GetHeaderSize());
    }
    if (size < expected)
    {
      error = "File '" + file + "' is missing, or shorter than the " +
        std::to_string(static_cast<long long>(expected)) + " bytes that reader " + name +
        " needs; get it again, or correct the reader's settings.";
      return false;
    }
  }
  return true;
}

bool CheckSlices(vtkAlgorithm* reader, int first, int last, std::string& error)
{
  auto* const images = vtkImageReader2::SafeDownCast(reader);
  if (!images || !images->IsA("vtkTIFFReader") || images->GetFileName())
  {
    return true;
  }
  for (int slice = first; slice <= last; ++slice)
  {
    images->ComputeInternalFileName(slice);
    const char* const file = images->GetInternalFileName();
    if (!file || !images->CanReadFile(file))
    {
      error = "File '" + std::string(file ? file : "") + "' of slice " + std::to_string(slice) +
        " of reader " + reader->GetClassName() + " cannot be opened or is damaged; get it again.";
      return false;
    }
  }
  return true;
}

}
