// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/ReaderVolume.h"

#include "VolumeFiles/FileFacts.h"
#include "VolumeFiles/ReaderErrors.h"
#include "VolumeFiles/ReaderFiles.h"
#include "VolumeFiles/ReaderOutput.h"
#include "VolumeFiles/SlabChunk.h"

#include <vtkAlgorithm.h>
#include <vtkImageData.h>
#include <vtkInformation.h>

#include <algorithm>
#include <initializer_list>
#include <mutex>

namespace TemporalCoherence
{

namespace
{

constexpr std::size_t MostOfSlab = std::size_t(4) << 20;
constexpr std::size_t MostOfSlice = std::size_t(64) << 20;
constexpr double MostOfWhole = 1073741824.0;

bool IsOneOf(vtkAlgorithm* reader, std::initializer_list<const char*> classes)
{
  return std::any_of(
    classes.begin(), classes.end(), [&](const char* name) { return reader->IsA(name) != 0; });
}

/// True if a reader can be asked for a part of the volume.
bool GivesParts(vtkAlgorithm* reader)
{
  // The first two write beyond the end of the memory of a part, though the second one claims to
  // know parts. The third one makes mistakes in text, and refuses parts of compressed files.
  if (IsOneOf(reader,
        { "vtkMetaImageReader", "vtkDICOMImageReader", "vtkNrrdReader", "vtkSLCReader",
          "vtkTGAReader", "vtkOMETIFFReader" }))
  {
    return false;
  }
  return IsOneOf(reader, { "vtkNIFTIImageReader", "vtkMINCImageReader", "vtkNetCDFReader" }) ||
    reader->GetOutputInformation(0)->Has(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT());
}

double BytesOf(const Extent& whole, std::size_t sampleSize)
{
  const glm::dvec3 size = whole.Size();
  return size.x * size.y * size.z * static_cast<double>(sampleSize);
}

class ReaderVolume : public VolumeFile
{
public:
  ReaderVolume(vtkAlgorithm* reader, const std::string& arrayName)
    : Reader(reader)
    , Errors(reader)
    , ArrayName(arrayName)
  {
  }
  ReaderVolume(const ReaderVolume&) = delete;
  ReaderVolume& operator=(const ReaderVolume&) = delete;

  bool Open(std::string& error);

  bool ReadChunk(
    std::size_t level, const glm::ivec3& chunk, void* samples, std::string& error) const override;

  std::string Identity() const override { return this->Facts; }
  bool HasIdentity() const override { return !FilesOf(this->Reader).empty(); }

private:
  bool ReadFirst(std::string& error);
  bool CheckWhole(std::size_t sampleSize, std::string& error) const;
  void FindPlace();
  void FindFacts();
  void ReleaseOutput() const;

  vtkSmartPointer<vtkAlgorithm> Reader;
  mutable ReaderErrors Errors;
  std::string ArrayName;
  Extent Whole;
  bool IsWhole = false; ///< the reader reads all, or nothing
  std::string Facts;
  mutable std::mutex Mutex;
};

bool ReaderVolume::Open(std::string& error)
{
  if (!UpdateInformation(this->Reader, this->Errors, this->Whole, error) ||
    !CheckFiles(this->Reader, this->Whole.Ends.data(), error))
  {
    return false;
  }
  this->IsWhole = !GivesParts(this->Reader);
  if (!this->ReadFirst(error))
  {
    return false;
  }
  this->FindPlace();
  this->FindFacts();
  return true;
}

/// Read as little as possible, to learn the type of samples.
bool ReaderVolume::ReadFirst(std::string& error)
{
  Extent asked = this->Whole;
  if (this->IsWhole)
  {
    if (!this->CheckWhole(1, error))
    {
      return false;
    }
  }
  else
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      asked.Ends[2 * axis + 1] = asked.Ends[2 * axis];
    }
  }
  ReadSamples first;
  if (!ReadPart(this->Reader, this->Errors, asked, this->ArrayName, first, error))
  {
    return false;
  }
  this->SampleType = first.Type;
  this->IsWhole = this->IsWhole || first.Part.Contains(this->Whole);
  if (this->IsWhole && !this->CheckWhole(SizeOf(first.Type), error))
  {
    this->ReleaseOutput();
    return false;
  }
  return true;
}

/// Check that all samples fit into memory.
bool ReaderVolume::CheckWhole(std::size_t sampleSize, std::string& error) const
{
  const double bytes = BytesOf(this->Whole, sampleSize);
  if (bytes <= MostOfWhole)
  {
    return true;
  }
  error = ReaderText(this->Reader) + "reads the whole volume at once, but it has " +
    std::to_string(static_cast<long long>(bytes)) +
    " bytes or more; convert it to a format that is read in parts, e.g. to VTK's XML images.";
  return false;
}

void ReaderVolume::FindPlace()
{
  vtkInformation* const info = this->Reader->GetOutputInformation(0);
  VolumeLevel level;
  level.Dimensions = glm::ivec3(this->Whole.Size());
  level.Chunk = SlabChunk(level.Dimensions, SizeOf(this->SampleType), MostOfSlab, MostOfSlice);
  if (info->Has(vtkDataObject::SPACING()))
  {
    info->Get(vtkDataObject::SPACING(), &level.Spacing.x);
  }
  if (info->Has(vtkDataObject::ORIGIN()))
  {
    info->Get(vtkDataObject::ORIGIN(), &level.Origin.x);
  }
  // VTK's origin is the place of sample (0, 0, 0), even if the extent begins elsewhere.
  level.Origin += level.Spacing * glm::dvec3(this->Whole.First());
  this->Resolutions = { level };
  if (!this->IsWhole)
  {
    this->ReleaseOutput();
  }
}

void ReaderVolume::FindFacts()
{
  this->Facts = std::string(this->Reader->GetClassName()) + ", array '" + this->ArrayName + "'\n";
  for (const std::string& file : FilesOf(this->Reader))
  {
    this->Facts += FileFacts(file);
  }
}

/// Keep no memory. The reader reads anew next time.
void ReaderVolume::ReleaseOutput() const
{
  this->Reader->GetOutputDataObject(0)->ReleaseData();
}

bool ReaderVolume::ReadChunk(
  std::size_t, const glm::ivec3& chunk, void* samples, std::string& error) const
{
  const VolumeLevel& level = this->Resolutions.front();
  const glm::ivec3 first = this->Whole.First() + chunk * level.Chunk;
  const glm::ivec3 size = glm::min(level.Chunk, level.Dimensions - chunk * level.Chunk);
  const glm::ivec3 last = first + (size - 1);
  const Extent part{ { first.x, last.x, first.y, last.y, first.z, last.z } };
  const std::lock_guard<std::mutex> lock(this->Mutex);
  ReadSamples found;
  if (!ReadPart(this->Reader, this->Errors, this->IsWhole ? this->Whole : part, this->ArrayName,
        found, error))
  {
    return false;
  }
  const bool isSame = found.Type == this->SampleType;
  if (isSame)
  {
    CopyPart(found, part, level.Chunk, samples);
  }
  else
  {
    error = ReaderText(this->Reader) +
      "gives samples of another type than before; do not change the reader while it is in use.";
  }
  if (!this->IsWhole)
  {
    this->ReleaseOutput();
  }
  return isSame;
}

}

std::unique_ptr<VolumeFile> OpenReader(
  vtkAlgorithm* reader, const std::string& arrayName, std::string& error)
{
  if (!reader)
  {
    error = "There is no reader; set one.";
    return nullptr;
  }
  auto volume = std::make_unique<ReaderVolume>(reader, arrayName);
  if (!volume->Open(error))
  {
    return nullptr;
  }
  return volume;
}

}
