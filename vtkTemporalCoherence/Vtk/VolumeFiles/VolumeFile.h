// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VolumeFile_h
#define TemporalCoherence_VolumeFile_h

#include "Scene/ScalarType.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// One resolution of a volume: a regular array of samples, in chunks.
struct VolumeLevel
{
  glm::ivec3 Dimensions{ 0 }; ///< samples along x, y and z; positive
  glm::ivec3 Chunk{ 0 };      ///< samples of a chunk along each axis; positive
  glm::dvec3 Spacing{ 1.0 };  ///< distance of samples, in the unit of the file
  glm::dvec3 Origin{ 0.0 };   ///< place of sample (0, 0, 0), in the same unit

  /// Chunks along each axis. Those at the far ends may reach beyond the volume.
  glm::ivec3 NumberOfChunks() const { return (this->Dimensions - 1) / this->Chunk + 1; }

  /// Samples of a chunk.
  std::size_t SamplesOfChunk() const
  {
    return static_cast<std::size_t>(this->Chunk.x) * static_cast<std::size_t>(this->Chunk.y) *
      static_cast<std::size_t>(this->Chunk.z);
  }
};

/// Which volume of a file to read, if it holds several.
struct VolumeChoice
{
  int Channel = 0;   ///< from 0
  int TimePoint = 0; ///< from 0
  std::string Array; ///< name of a data set or of an image in the file; empty: the first
};

/// A volume of one component in a file or a folder. Its samples are read chunk by chunk, in any
/// order. Formats derive from this.
///
/// A reader trusts nothing that it reads. Sizes are checked before memory is asked for, and names
/// in metadata do not lead out of the volume's folder.
class VolumeFile
{
public:
  virtual ~VolumeFile() = default;

  ScalarType Type() const { return this->SampleType; }

  /// The resolutions, from the finest; at least one.
  const std::vector<VolumeLevel>& Levels() const { return this->Resolutions; }

  /// Read and decode a chunk. Thread-safe.
  /// \param level   position in Levels()
  /// \param chunk   position in the grid of chunks
  /// \param samples room for all samples of a chunk, x fastest, in this machine's byte order. Those
  ///                beyond the end of the volume may keep any value
  /// \param error   receives what is wrong, with the name of the file, in one sentence
  /// \return false if the chunk cannot be read; its samples are undefined then. A chunk that the
  ///         format allows to be missing has the fill value, which is no error
  virtual bool ReadChunk(
    std::size_t level, const glm::ivec3& chunk, void* samples, std::string& error) const = 0;

  /// The address of sample (0, 0, 0) of a level whose samples lie in a mapped file, x fastest and
  /// without gaps, in this machine's byte order, aligned to their size. Null for other levels.
  virtual const void* MappedSamples(std::size_t /*level*/) const { return nullptr; }

  /// True once samples could not be read through MappedSamples(), for example because the file
  /// became shorter. Such samples read as zero. Thread-safe; ask after a picture.
  /// \param error receives what is wrong and what to do, in one sentence
  virtual bool HasFailed(std::string& /*error*/) const { return false; }

  /// A text that differs if the volume's samples may have changed: names, sizes and modification
  /// times of files, and what was chosen.
  virtual std::string Identity() const = 0;

  /// False if the identity does not tell this volume from others: a reader may have no file.
  virtual bool HasIdentity() const { return true; }

protected:
  VolumeFile() = default;
  VolumeFile(const VolumeFile&) = default;
  VolumeFile& operator=(const VolumeFile&) = default;

  ScalarType SampleType = ScalarType::UInt8;
  std::vector<VolumeLevel> Resolutions;
};

}

#endif
