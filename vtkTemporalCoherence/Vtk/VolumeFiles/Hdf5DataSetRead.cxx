// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of Hdf5DataSet that reads.

#include "VolumeFiles/Hdf5DataSet.h"

#include <algorithm>

namespace TemporalCoherence
{

std::size_t Hdf5DataSet::SamplesOfChunk() const
{
  return static_cast<std::size_t>(this->ChunkSize.x) * static_cast<std::size_t>(this->ChunkSize.y) *
    static_cast<std::size_t>(this->ChunkSize.z);
}

bool Hdf5DataSet::Read(const glm::ivec3& first, void* samples, std::string& error) const
{
  if (this->Read(first, samples))
  {
    return true;
  }
  error = this->Text + "cannot be read at sample (" + std::to_string(first.x) + ", " +
    std::to_string(first.y) + ", " + std::to_string(first.z) +
    "): the file is damaged or incomplete; get it again.";
  return false;
}

bool Hdf5DataSet::Read(const glm::ivec3& first, void* samples) const
{
  StoredChunk stored;
  {
    const Hdf5Turn turn;
    const Stored found = this->FindChunk(first, stored);
    if (found != Stored::Decodable)
    {
      return found == Stored::ForHdf5 && this->ReadByHdf5(first, samples);
    }
  }
  const std::size_t bytes = this->SamplesOfChunk() * this->FileSampleSize;
  return DecodeChunk(stored, this->FileSampleSize, samples, bytes) &&
    (!this->NeedsConversion || this->Convert(samples));
}

/// Read the bytes of a chunk if they are to be decoded without HDF5. Sizes are checked in any case:
/// HDF5 1.10 reads beyond the end of a chunk that is too short.
Hdf5DataSet::Stored Hdf5DataSet::FindChunk(const glm::ivec3& first, StoredChunk& stored) const
{
  if (!this->IsChunked)
  {
    return Stored::ForHdf5;
  }
  const hsize_t offset[3] = { static_cast<hsize_t>(first.z), static_cast<hsize_t>(first.y),
    static_cast<hsize_t>(first.x) };
  const std::size_t bytes = this->SamplesOfChunk() * this->FileSampleSize;
  hsize_t size = 0;
  if (H5Dget_chunk_storage_size(this->Data.Get(), offset, &size) < 0 || size == 0)
  {
    return Stored::ForHdf5;
  }
  if (!this->IsDecodedHere)
  {
    return this->FilterCount > 0 || size == bytes ? Stored::ForHdf5 : Stored::Damaged;
  }
  if (size > MostStoredBytes(bytes))
  {
    return Stored::Damaged;
  }
  stored.Bytes.resize(static_cast<std::size_t>(size));
  std::uint32_t skipped = 0;
#if H5_VERSION_GE(2, 0, 0)
  std::size_t room = stored.Bytes.size();
  const herr_t result =
    H5Dread_chunk2(this->Data.Get(), H5P_DEFAULT, offset, &skipped, stored.Bytes.data(), &room);
#else
  const herr_t result =
    H5Dread_chunk(this->Data.Get(), H5P_DEFAULT, offset, &skipped, stored.Bytes.data());
#endif
  if (result < 0)
  {
    return Stored::Damaged;
  }
  stored.Filters = this->Filters.Without(skipped);
  return Stored::Decodable;
}

/// Convert a chunk in its place. A sample in the file is never larger than in memory.
bool Hdf5DataSet::Convert(void* samples) const
{
  const Hdf5Turn turn;
  return H5Tconvert(this->FileType.Get(), this->MemoryType, this->SamplesOfChunk(), samples,
           nullptr, H5P_DEFAULT) >= 0;
}

/// Let HDF5 read, decode and convert a chunk. Chunks that were not written get the fill value.
bool Hdf5DataSet::ReadByHdf5(const glm::ivec3& first, void* samples) const
{
  hsize_t start[3], count[3], room[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int x = 2 - axis;
    start[axis] = static_cast<hsize_t>(first[x]);
    count[axis] = static_cast<hsize_t>(std::min(this->ChunkSize[x], this->Size[x] - first[x]));
    room[axis] = static_cast<hsize_t>(this->ChunkSize[x]);
  }
  const hsize_t origin[3] = {};
  const Hdf5Handle from(H5Dget_space(this->Data.Get()), H5Sclose);
  const Hdf5Handle to(H5Screate_simple(3, room, nullptr), H5Sclose);
  return from.IsValid() && to.IsValid() &&
    H5Sselect_hyperslab(from.Get(), H5S_SELECT_SET, start, nullptr, count, nullptr) >= 0 &&
    H5Sselect_hyperslab(to.Get(), H5S_SELECT_SET, origin, nullptr, count, nullptr) >= 0 &&
    H5Dread(this->Data.Get(), this->MemoryType, to.Get(), from.Get(), H5P_DEFAULT, samples) >= 0;
}

}
