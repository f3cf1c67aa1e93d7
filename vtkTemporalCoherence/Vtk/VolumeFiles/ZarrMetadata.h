// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ZarrMetadata_h
#define TemporalCoherence_ZarrMetadata_h

#include "VolumeFiles/ChunkCodec.h"
#include "VolumeFiles/JsonFiles.h"
#include "VolumeFiles/SampleBytes.h"

#include <string>
#include <vector>

namespace TemporalCoherence
{

/// Chunks of one file. Version 3 of Zarr may store many, with an index of their places.
struct ZarrShard
{
  std::vector<int> Chunks;     ///< along each axis; empty if each file holds one chunk
  std::size_t Count = 1;       ///< chunks of a file
  bool IsIndexAtStart = false; ///< else it is at the file's end
  bool HasIndexChecksum = false;
  bool IsIndexBigEndian = false;
};

/// An array of a Zarr volume. Its axes are in the order of the file, the slowest first.
struct ZarrArray
{
  std::vector<int> Shape; ///< samples along each axis
  std::vector<int> Chunk; ///< samples of a chunk along each axis
  std::size_t ChunkBytes = 0;
  ScalarType Type = ScalarType::UInt8;
  ChunkCodec Codec;
  SampleBytes FillValue{};
  std::string KeyPrefix; ///< start of the names of chunks' files
  char Separator = '.';  ///< between the positions in these names
  ZarrShard Shard;
};

/// Read an array's metadata, of version 2 or 3.
/// \param files  reads the files
/// \param folder the array's folder
/// \param error  receives what is wrong, in one sentence
/// \return Missing if the folder is not an array
FileState ReadZarrArray(
  JsonFiles& files, const std::filesystem::path& folder, ZarrArray& array, std::string& error);

/// Read an array's metadata of version 2 of Zarr.
/// \param metadata contents of .zarray
/// \param defect   receives what is wrong; the file's name is the sentence's subject
bool ParseZarrArray2(const Json& metadata, ZarrArray& array, std::string& defect);

/// Read an array's metadata of version 3 of Zarr.
/// \param metadata contents of zarr.json
/// \param defect   receives what is wrong; the file's name is the sentence's subject
bool ParseZarrArray3(const Json& metadata, ZarrArray& array, std::string& defect);

/// Read the sizes along all axes: positive integers less than 2^31.
bool ParseZarrSizes(const Json& list, std::vector<int>& sizes);

/// Check the array's sizes, and compute the bytes of a chunk.
/// \pre all sizes are positive
bool CheckZarrSizes(ZarrArray& array, std::string& defect);

/// Read the value of samples that are not stored.
/// \return false if the value is none of this type
bool ParseZarrFillValue(const Json& value, ScalarType type, SampleBytes& bytes);

}

#endif
