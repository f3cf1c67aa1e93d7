// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of Hdf5DataSet that reads.

#include "VolumeFiles/Hdf5DataSet.h"

#include <algorithm>

namespace TemporalCoherence
{

std::size_t Hdf5DataSet::ChunkBytes() const
{
  return this->SampleSize() * static_cast<std::size_t>(this->ChunkSize.x) *
    static_cast<std::size_t>(this->ChunkSize.y) * static_cast<std::size_t>(this->ChunkSize.z);
}

bool Hdf5DataSet::Read(const glm::ivec3& first, void* samples, std::string& error) const
{
  if (this->IsDecodedHere && this->ReadAndDecode(first, samples))
  {
    return true;
  }
  const Hdf5Turn turn;
  if (this->ReadByHdf5(first, samples))
  {
    return true;
  }
  error = this->Text + "cannot be read at sample (" + std::to_string(first.x) + ", " +
    std::to_string(first.y) + ", " + std::to_string(first.z) +
    "): the file is damaged or incomplete; get it again.";
  return false;
}

/// Read a chunk, then decode it while others read.
/// \return false if HDF5 is to read it
bool Hdf5DataSet::ReadAndDecode(const glm::ivec3& first, void* samples) const
{
  StoredChunk stored;
  {
    const Hdf5Turn turn;
    if (!this->FindChunk(first, stored))
    {
      return false;
    }
  }
  return DecodeChunk(stored, this->SampleSize(), samples, this->ChunkBytes());
}

/// Read the stored bytes of a chunk.
/// \return false if it was not written, or is for HDF5 to judge
bool Hdf5DataSet::FindChunk(const glm::ivec3& first, StoredChunk& stored) const
{
  const hsize_t offset[3] = { static_cast<hsize_t>(first.z), static_cast<hsize_t>(first.y),
    static_cast<hsize_t>(first.x) };
  hsize_t size = 0;
  if (H5Dget_chunk_storage_size(this->Data.Get(), offset, &size) < 0 || size == 0 ||
    size > MostStoredBytes(this->ChunkBytes()))
  {
    return false;
  }
  stored.Bytes.resize(static_cast<std::size_t>(size));
  std::uint32_t skipped = 0;
  if (H5Dread_chunk(this->Data.Get(), H5P_DEFAULT, offset, &skipped, stored.Bytes.data()) < 0)
  {
    return false;
  }
  stored.Filters = this->Filters.Without(skipped);
  return true;
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
