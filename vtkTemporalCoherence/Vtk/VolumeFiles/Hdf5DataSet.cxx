// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/Hdf5DataSet.h"

#include "VolumeFiles/Hdf5Types.h"
#include "VolumeFiles/SlabChunk.h"

#include <limits>

namespace TemporalCoherence
{

namespace
{

constexpr std::size_t MostOfSlab = std::size_t(4) << 20;
constexpr double MostOfChunk = 2147483647.0;

/// HDF5 names the slowest axis first.
glm::dvec3 FromHdf5(const hsize_t (&sizes)[3])
{
  return { static_cast<double>(sizes[2]), static_cast<double>(sizes[1]),
    static_cast<double>(sizes[0]) };
}

}

bool Hdf5DataSet::Open(const Hdf5File& file, const std::string& name, std::string& error)
{
  this->Text = file.DataSetText(name);
  const Hdf5Handle object = file.OpenObject(name);
  if (!object.IsValid())
  {
    error = file.WhyNotOpened(name);
    return false;
  }
  if (H5Iget_type(object.Get()) != H5I_DATASET)
  {
    error = this->Text + "is no data set but a group or a type; choose a data set.";
    return false;
  }
  this->Data = Hdf5Handle(H5Dopen2(file.Id(), name.c_str(), file.Access()), H5Dclose);
  if (!this->Data.IsValid())
  {
    error = file.WhyNotOpened(name);
    return false;
  }
  return this->FindType(error) && this->FindSize(error) && this->FindStorage(error);
}

bool Hdf5DataSet::FindType(std::string& error)
{
  this->FileType = Hdf5Handle(H5Dget_type(this->Data.Get()), H5Tclose);
  if (!FindScalarType(this->FileType.Get(), this->SampleType))
  {
    error = this->Text +
      "has samples that are no single integers or floating-point numbers of 8 to 64 bits; choose "
      "another data set, or convert it.";
    return false;
  }
  this->MemoryType = MemoryTypeOf(this->SampleType);
  this->FileSampleSize = H5Tget_size(this->FileType.Get());
  this->NeedsConversion = H5Tequal(this->FileType.Get(), this->MemoryType) <= 0;
  return true;
}

bool Hdf5DataSet::FindSize(std::string& error)
{
  const Hdf5Handle space(H5Dget_space(this->Data.Get()), H5Sclose);
  hsize_t sizes[3] = {};
  if (H5Sget_simple_extent_ndims(space.Get()) != 3 ||
    H5Sget_simple_extent_dims(space.Get(), sizes, nullptr) != 3)
  {
    error = this->Text + "does not have three dimensions; choose another data set.";
    return false;
  }
  const glm::dvec3 size = FromHdf5(sizes);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (size[axis] < 1.0 || size[axis] > std::numeric_limits<int>::max())
    {
      error = this->Text + "has " + std::to_string(sizes[2 - axis]) +
        " samples along an axis; from 1 to 2147483647 can be read.";
      return false;
    }
  }
  this->Size = glm::ivec3(size);
  return true;
}

bool Hdf5DataSet::FindStorage(std::string& error)
{
  const Hdf5Handle properties(H5Dget_create_plist(this->Data.Get()), H5Pclose);
  const H5D_layout_t layout = H5Pget_layout(properties.Get());
  if (layout == H5D_VIRTUAL || H5Pget_external_count(properties.Get()) != 0)
  {
    error = this->Text +
      (layout == H5D_VIRTUAL ? "is virtual: it refers to other data sets"
                             : "keeps its samples in other files") +
      ", which are not followed; copy the samples into one HDF5 file.";
    return false;
  }
  this->IsChunked = layout == H5D_CHUNKED;
  if (!this->IsChunked)
  {
    this->ChunkSize = SlabChunk(this->Size, this->SampleSize(), MostOfSlab, MostOfSlab);
    return this->CheckStoredBytes(layout, error);
  }
  hsize_t sizes[3] = {};
  if (H5Pget_chunk(properties.Get(), 3, sizes) != 3)
  {
    error = this->Text + "has chunks that cannot be understood; write the file again.";
    return false;
  }
  const glm::dvec3 chunk = FromHdf5(sizes);
  if (glm::any(glm::lessThan(chunk, glm::dvec3(1.0))) ||
    chunk.x * chunk.y * chunk.z * static_cast<double>(this->SampleSize()) > MostOfChunk)
  {
    error =
      this->Text + "has chunks of 2 GiB or more; write the file again with chunks of about 1 MiB.";
    return false;
  }
  this->ChunkSize = glm::ivec3(chunk);
  return this->FindFilters(properties.Get(), error);
}

/// Check the number of stored bytes of a data set without chunks. HDF5 1.10 reads beyond the end
/// of samples that are stored among the metadata.
bool Hdf5DataSet::CheckStoredBytes(H5D_layout_t layout, std::string& error) const
{
  const glm::dvec3 size(this->Size);
  const double expected = size.x * size.y * size.z * static_cast<double>(this->FileSampleSize);
  const auto stored = static_cast<double>(H5Dget_storage_size(this->Data.Get()));
  const bool isUnwritten = stored == 0.0 && layout == H5D_CONTIGUOUS;
  if (stored < expected && !isUnwritten)
  {
    error = this->Text + "has fewer samples than its size says; get the file again.";
    return false;
  }
  return true;
}

/// See whether HDF5 is needed to decode chunks, and whether it is able to.
bool Hdf5DataSet::FindFilters(hid_t properties, std::string& error)
{
  const int count = H5Pget_nfilters(properties);
  this->FilterCount = count;
  // Without filters, HDF5 reads into place.
  unsigned options = 0;
  this->IsDecodedHere = count > 0 && H5Pget_chunk_opts(properties, &options) >= 0 &&
    (options & H5D_CHUNK_DONT_FILTER_PARTIAL_CHUNKS) == 0;
  for (int i = 0; i < count; ++i)
  {
    unsigned flags = 0, config = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter = H5Pget_filter2(
      properties, static_cast<unsigned>(i), &flags, &values, nullptr, 0, nullptr, &config);
    if (filter == H5Z_FILTER_SHUFFLE && i == 0)
    {
      this->Filters.IsShuffled = true;
    }
    else if (filter == H5Z_FILTER_DEFLATE && i == count - 1)
    {
      this->Filters.IsDeflated = true;
    }
    else
    {
      this->IsDecodedHere = false;
      if (filter < 0 || H5Zfilter_avail(filter) <= 0)
      {
        error = this->Text + "is compressed by filter " + std::to_string(filter) +
          ", which this HDF5 does not know; install its plugin, or compress with deflate (gzip).";
        return false;
      }
    }
  }
  return true;
}

void Hdf5DataSet::TakeAsUnsigned()
{
  if (this->SampleType == ScalarType::Int16)
  {
    this->SampleType = ScalarType::UInt16;
  }
}

}
