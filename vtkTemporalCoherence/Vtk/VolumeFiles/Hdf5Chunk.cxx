// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/Hdf5Chunk.h"

#include <zlib.h>

#include <cstring>
#include <new>

namespace TemporalCoherence
{

namespace
{

/// Decompress exactly as many bytes as expected.
bool Inflate(const std::vector<unsigned char>& from, unsigned char* to, std::size_t bytes)
{
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK)
  {
    throw std::bad_alloc();
  }
  stream.next_in = const_cast<unsigned char*>(from.data()); // zlib does not write there
  stream.avail_in = static_cast<uInt>(from.size());
  stream.next_out = to;
  stream.avail_out = static_cast<uInt>(bytes);
  const int result = inflate(&stream, Z_FINISH);
  const bool isWhole = result == Z_STREAM_END && stream.avail_out == 0;
  inflateEnd(&stream);
  if (result == Z_MEM_ERROR)
  {
    throw std::bad_alloc();
  }
  return isWhole;
}

/// Put the bytes of each sample together, of a known size.
template <std::size_t SampleSize>
void UnshuffleSamples(const unsigned char* from, unsigned char* to, std::size_t samples)
{
  for (std::size_t s = 0; s < samples; ++s)
  {
    for (std::size_t byte = 0; byte < SampleSize; ++byte)
    {
      to[s * SampleSize + byte] = from[byte * samples + s];
    }
  }
}

/// HDF5 stores first the lowest bytes of all samples, then their second bytes, and so on.
void Unshuffle(
  const unsigned char* from, std::size_t sampleSize, unsigned char* to, std::size_t bytes)
{
  switch (sampleSize)
  {
    case 2:
      UnshuffleSamples<2>(from, to, bytes / 2);
      break;
    case 4:
      UnshuffleSamples<4>(from, to, bytes / 4);
      break;
    case 8:
      UnshuffleSamples<8>(from, to, bytes / 8);
      break;
    default:
      std::memcpy(to, from, bytes);
      break;
  }
}

}

Hdf5Filters Hdf5Filters::Without(std::uint32_t skipped) const
{
  Hdf5Filters filters = *this;
  std::uint32_t bit = 1;
  for (bool Hdf5Filters::*filter : { &Hdf5Filters::IsShuffled, &Hdf5Filters::IsDeflated })
  {
    if (this->*filter)
    {
      filters.*filter = (skipped & bit) == 0;
      bit <<= 1;
    }
  }
  return filters;
}

std::size_t MostStoredBytes(std::size_t chunkBytes)
{
  return compressBound(static_cast<uLong>(chunkBytes));
}

bool DecodeChunk(
  const StoredChunk& stored, std::size_t sampleSize, void* samples, std::size_t chunkBytes)
{
  auto* const to = static_cast<unsigned char*>(samples);
  if (!stored.Filters.IsDeflated && stored.Bytes.size() != chunkBytes)
  {
    return false;
  }
  if (!stored.Filters.IsShuffled)
  {
    if (stored.Filters.IsDeflated)
    {
      return Inflate(stored.Bytes, to, chunkBytes);
    }
    std::memcpy(to, stored.Bytes.data(), chunkBytes);
    return true;
  }
  if (!stored.Filters.IsDeflated)
  {
    Unshuffle(stored.Bytes.data(), sampleSize, to, chunkBytes);
    return true;
  }
  std::vector<unsigned char> shuffled(chunkBytes);
  if (!Inflate(stored.Bytes, shuffled.data(), chunkBytes))
  {
    return false;
  }
  Unshuffle(shuffled.data(), sampleSize, to, chunkBytes);
  return true;
}

}
