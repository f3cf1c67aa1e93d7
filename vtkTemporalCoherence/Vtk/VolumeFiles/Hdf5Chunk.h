// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Hdf5Chunk_h
#define TemporalCoherence_Hdf5Chunk_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// The filters of a data set that can be undone without HDF5: shuffle, then deflate, each optional.
struct Hdf5Filters
{
  bool IsShuffled = false;
  bool IsDeflated = false;

  /// Those that apply to a chunk.
  /// \param skipped a bit for each filter of the data set that this chunk lacks, the first in bit 0
  Hdf5Filters Without(std::uint32_t skipped) const;
};

/// A chunk in the bytes of the file, mostly compressed.
struct StoredChunk
{
  std::vector<unsigned char> Bytes;
  Hdf5Filters Filters;
};

/// An upper bound of the stored size of a chunk. Damaged files may tell more.
std::size_t MostStoredBytes(std::size_t chunkBytes);

/// Undo the filters of a chunk. Needs no Hdf5Turn.
/// \param sampleSize bytes of a sample
/// \param samples    room for the chunk
/// \param chunkBytes size of the room
/// \return false if the stored bytes do not give a chunk of this size
bool DecodeChunk(
  const StoredChunk& stored, std::size_t sampleSize, void* samples, std::size_t chunkBytes);

}

#endif
