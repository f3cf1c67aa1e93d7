// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/RawVolume.h"

#include "VolumeFiles/MappedFile.h"
#include "VolumeFiles/RandomAccessFile.h"
#include "VolumeFiles/SampleBytes.h"
#include "VolumeFiles/SlabChunk.h"

#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>
#include <utility>

namespace TemporalCoherence
{
namespace
{

constexpr std::size_t MostBytesOfChunk = std::size_t(4) << 20;

class RawVolume : public VolumeFile
{
public:
  RawVolume(std::unique_ptr<RandomAccessFile> file, const RawLayout& layout, std::uint64_t bytes);

  bool ReadChunk(
    std::size_t level, const glm::ivec3& chunk, void* samples, std::string& error) const override;
  const void* MappedSamples(std::size_t level) const override;
  bool HasFailed(std::string& error) const override;
  std::string Identity() const override;

private:
  /// Read the samples of a chunk that lie in the volume, without a change of bytes.
  bool ReadRows(const glm::ivec3& first, const glm::ivec3& extent, std::byte* samples,
    std::string& error) const;

  std::unique_ptr<RandomAccessFile> File;
  std::unique_ptr<MappedFile> Mapped; ///< null if samples cannot be used in place
  RawLayout Layout;
};

RawVolume::RawVolume(
  std::unique_ptr<RandomAccessFile> file, const RawLayout& layout, std::uint64_t bytes)
  : File(std::move(file))
  , Layout(layout)
{
  const std::size_t size = SizeOf(layout.Type);
  this->SampleType = layout.Type;
  this->Resolutions.push_back(
    { layout.Dimensions, SlabChunk(layout.Dimensions, size, MostBytesOfChunk, MostBytesOfChunk),
      layout.Spacing, layout.Origin });
  if ((size == 1 || layout.IsBigEndian != IsLittleEndianMachine()) && layout.Offset % size == 0)
  {
    this->Mapped = MappedFile::Map(*this->File, layout.Offset + bytes);
  }
}

bool RawVolume::ReadRows(
  const glm::ivec3& first, const glm::ivec3& extent, std::byte* samples, std::string& error) const
{
  const VolumeLevel& level = this->Resolutions.front();
  const std::size_t size = SizeOf(this->SampleType);
  const auto offsetOf = [&](int y, int z)
  {
    const auto row =
      static_cast<std::uint64_t>(first.z + z) * static_cast<std::uint64_t>(level.Dimensions.y) +
      static_cast<std::uint64_t>(first.y + y);
    return this->Layout.Offset +
      size *
      (row * static_cast<std::uint64_t>(level.Dimensions.x) + static_cast<std::uint64_t>(first.x));
  };
  const std::size_t row = size * static_cast<std::size_t>(level.Chunk.x);
  const std::size_t slice = row * static_cast<std::size_t>(level.Chunk.y);
  // Rows, or slices, that follow each other both in the file and in the chunk are read at once.
  const bool wholeRows = level.Chunk.x == level.Dimensions.x;
  const bool wholeSlices = wholeRows && level.Chunk.y == level.Dimensions.y;
  const int rows = wholeRows ? extent.y : 1;
  const int slices = wholeSlices ? extent.z : 1;
  const std::size_t run = size * static_cast<std::size_t>(extent.x) *
    static_cast<std::size_t>(rows) * static_cast<std::size_t>(slices);
  for (int z = 0; z < extent.z; z += slices)
  {
    for (int y = 0; y < extent.y; y += rows)
    {
      std::byte* target =
        samples + static_cast<std::size_t>(z) * slice + static_cast<std::size_t>(y) * row;
      if (!this->File->Read(offsetOf(y, z), target, run, error))
      {
        return false;
      }
    }
  }
  return true;
}

bool RawVolume::ReadChunk(
  std::size_t level, const glm::ivec3& chunk, void* samples, std::string& error) const
{
  const VolumeLevel& only = this->Resolutions.front();
  const glm::ivec3 chunks = only.NumberOfChunks();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (level != 0 || chunk[axis] < 0 || chunk[axis] >= chunks[axis])
    {
      error = "'" + this->File->Path() + "' has no chunk " + TextOf(chunk) + " at level " +
        std::to_string(level) + "; ask for chunks within NumberOfChunks().";
      return false;
    }
  }
  // Not from the mapping: reading tells of errors.
  const glm::ivec3 first = chunk * only.Chunk;
  const glm::ivec3 extent = glm::min(only.Chunk, only.Dimensions - first);
  if (!this->ReadRows(first, extent, static_cast<std::byte*>(samples), error))
  {
    return false;
  }
  if (this->Layout.IsBigEndian == IsLittleEndianMachine())
  {
    SwapSampleBytes(this->SampleType, samples, only.SamplesOfChunk());
  }
  return true;
}

const void* RawVolume::MappedSamples(std::size_t level) const
{
  return level == 0 && this->Mapped ? this->Mapped->Data() + this->Layout.Offset : nullptr;
}

bool RawVolume::HasFailed(std::string& error) const
{
  if (!this->Mapped || !this->Mapped->IsBroken())
  {
    return false;
  }
  error = "Samples of '" + this->File->Path() +
    "' could not be read and count as 0: the file became shorter, or its disk does not answer; "
    "restore the file and open it again.";
  return true;
}

std::string RawVolume::Identity() const
{
  const RawLayout& layout = this->Layout;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(std::numeric_limits<double>::max_digits10);
  text << this->File->Path() << '|' << this->File->Size() << '|' << this->File->ModificationTime()
       << '|' << static_cast<int>(layout.Type) << '|' << layout.Offset << '|' << layout.IsBigEndian;
  for (int axis = 0; axis < 3; ++axis)
  {
    text << '|' << layout.Dimensions[axis] << '|' << layout.Spacing[axis] << '|'
         << layout.Origin[axis];
  }
  return text.str();
}

}

std::unique_ptr<VolumeFile> OpenRaw(
  const std::string& path, const RawLayout& layout, std::string& error)
{
  std::uint64_t bytes = 0;
  if (!CheckLayout(path, layout, error) || !BytesOf(layout.Dimensions, layout.Type, bytes))
  {
    return nullptr;
  }
  std::unique_ptr<RandomAccessFile> file = RandomAccessFile::Open(path, error);
  if (!file)
  {
    return nullptr;
  }
  if (layout.Offset > file->Size() || bytes > file->Size() - layout.Offset)
  {
    error = "'" + path + "' has " + std::to_string(file->Size()) + " bytes, but " +
      TextOf(layout.Dimensions) + " samples after " + std::to_string(layout.Offset) +
      " bytes need " + std::to_string(bytes) +
      " bytes more than these; correct the dimensions, the " +
      "type or the offset, or copy the file again.";
    return nullptr;
  }
  return std::make_unique<RawVolume>(std::move(file), layout, bytes);
}

}
