// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Hdf5DataSet_h
#define TemporalCoherence_Hdf5DataSet_h

#include "Scene/ScalarType.h"
#include "VolumeFiles/Hdf5Chunk.h"
#include "VolumeFiles/Hdf5Library.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <string>

namespace TemporalCoherence
{

/// A data set of three dimensions and one number per sample. All members but Read and the constant
/// ones need an Hdf5Turn, the destructor included.
class Hdf5DataSet
{
public:
  /// Open a data set and check that it can be read.
  /// \param error receives what cannot be read, in one sentence
  bool Open(const Hdf5File& file, const std::string& name, std::string& error);

  const glm::ivec3& Dimensions() const { return this->Size; }

  /// Chunks of the file. Data sets without chunks are read in slabs.
  const glm::ivec3& Chunk() const { return this->ChunkSize; }

  ScalarType Type() const { return this->SampleType; }

  /// Read integers of 16 bits as if they had no sign. Their bits stay as they are.
  void TakeAsUnsigned();

  /// Read a chunk. Thread-safe; takes an Hdf5Turn itself.
  /// \param first   its first sample, within Dimensions()
  /// \param samples room for a chunk
  /// \param error   receives what is wrong, in one sentence
  bool Read(const glm::ivec3& first, void* samples, std::string& error) const;

private:
  bool FindType(std::string& error);
  bool FindSize(std::string& error);
  bool FindStorage(std::string& error);
  bool CheckStoredBytes(H5D_layout_t layout, std::string& error) const;
  bool FindFilters(hid_t properties, std::string& error);

  /// What the file has of a chunk.
  enum class Stored
  {
    Decodable, ///< bytes to decode without HDF5
    ForHdf5,   ///< nothing, or bytes that HDF5 decodes
    Damaged
  };

  bool Read(const glm::ivec3& first, void* samples) const;
  Stored FindChunk(const glm::ivec3& first, StoredChunk& stored) const;
  bool Convert(void* samples) const;
  bool ReadByHdf5(const glm::ivec3& first, void* samples) const;

  std::size_t SampleSize() const { return SizeOf(this->SampleType); }
  std::size_t SamplesOfChunk() const;

  std::string Text; ///< "Data set 'name' of file 'path' "
  Hdf5Handle Data;
  Hdf5Handle FileType;
  std::size_t FileSampleSize = 1;     ///< bytes of a sample in the file
  hid_t MemoryType = H5I_INVALID_HID; ///< HDF5's own; not to be closed
  bool NeedsConversion = false;       ///< as the types differ
  ScalarType SampleType = ScalarType::UInt8;
  glm::ivec3 Size{ 0 };
  glm::ivec3 ChunkSize{ 0 };
  bool IsChunked = false;
  int FilterCount = 0;
  Hdf5Filters Filters;
  bool IsDecodedHere = false; ///< chunks are decoded without HDF5, while others read
};

}

#endif
