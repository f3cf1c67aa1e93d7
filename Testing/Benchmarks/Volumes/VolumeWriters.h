// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_VolumeWriters_h
#define Benchmarks_VolumeWriters_h

#include "Scene/ScalarType.h"

#include <glm/glm.hpp>

#include <string>

/// \file
/// Functions that write MixingLayer in the formats of volumes, slab by slab or chunk by chunk.

/// A volume to be written.
struct VolumeOrder
{
  std::string Path;
  glm::ivec3 Dimensions{ 0 };
  TemporalCoherence::ScalarType Type = TemporalCoherence::ScalarType::UInt8;
  std::string Codec; ///< the compression; empty: the format's default
  int Chunk = 64;    ///< samples of a chunk along each axis, for formats with chunks
};

/// Write plain samples in this machine's byte order.
/// \param error receives what is wrong and what to do, in one sentence
/// \return false on error
bool WriteRaw(const VolumeOrder& order, std::string& error);

/// Write the header of a MetaImage (.mhd), and the samples in a file beside it (.raw).
bool WriteMetaImage(const VolumeOrder& order, std::string& error);

/// Write a folder of TIFF files, one for each slice, the row y = 0 first: slice00000.tif and so on.
/// Codecs: none, lzw, deflate, zstd.
bool WriteTiff(const VolumeOrder& order, std::string& error);

/// Write a folder of OME-Zarr 0.4 (Zarr version 2), with all levels of a pyramid. The folder must
/// not exist, or be empty. Codecs: none, blosc-lz4 (the default), blosc-zstd, zstd, gzip.
bool WriteZarr(const VolumeOrder& order, std::string& error);

/// Write a file of Imaris (.ims), with all levels of a pyramid. Codecs: none, gzip (the default).
bool WriteImaris(const VolumeOrder& order, std::string& error);

#endif
