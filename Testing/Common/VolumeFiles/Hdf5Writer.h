// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Hdf5Writer_h
#define Testing_Hdf5Writer_h

#include "Scene/ScalarType.h"

#include <glm/glm.hpp>
#include <hdf5.h>

#include <string>
#include <vector>

enum class Hdf5Layout
{
  Imaris,
  BigDataViewer,
  DataSet ///< one level, named "/volume"
};

/// What an Hdf5Writer writes.
struct Hdf5Plan
{
  Hdf5Layout Layout = Hdf5Layout::Imaris;
  TemporalCoherence::ScalarType Type = TemporalCoherence::ScalarType::UInt8;
  bool IsSwapped = false;             ///< samples have the byte order that this machine has not
  std::vector<glm::ivec3> Dimensions; ///< of each level
  std::vector<glm::ivec3> Factors;    ///< of each level of BigDataViewer
  glm::ivec3 Chunk{ 16 };             ///< 0: no chunks
  bool IsShuffled = false;
  int Deflate = -1; ///< from 0 to 9; negative: none
  bool HasChecksums = false;
  double Fill = 0.0; ///< value of chunks that are not written
  glm::dvec3 BoxMin{ 0.0 }, BoxMax{ 1.0 };
  int Channel = 0, TimePoint = 0;
};

/// Writes a volume to an HDF5 file chunk by chunk, so that it need not fit into memory. Chunks that
/// are not written are missing in the file.
class Hdf5Writer
{
public:
  Hdf5Writer(const std::string& path, const Hdf5Plan& plan);
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  /// \param chunk   position in the grid of chunks
  /// \param samples those of a whole chunk, x fastest; of a volume without chunks, all samples
  /// \return false if the chunk cannot be written
  bool WriteChunk(std::size_t level, const glm::ivec3& chunk, const void* samples);

  /// Write a chunk that is compressed already, as the plan says.
  /// \param bytes those of the file
  bool WriteStoredChunk(
    std::size_t level, const glm::ivec3& chunk, const void* bytes, std::size_t size);

  /// Write all that is not yet in the file, and close it.
  /// \return false if something could not be written
  bool Close();

  /// False if something could not be written.
  bool IsGood() const { return this->Good; }

  static std::string DataName(const Hdf5Plan& plan, std::size_t level);

private:
  void AddLevel(std::size_t level);
  void AddImarisSize(const std::string& group, const glm::ivec3& size);
  void AddImarisBox();
  void AddFactors();
  void AddText(hid_t group, const std::string& name, const std::string& text);

  Hdf5Plan Plan;
  hid_t File;
  std::vector<hid_t> Data;
  bool Good = true;
};

#endif
