// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_VolumeWriters_h
#define Benchmarks_VolumeWriters_h

#include "Scene/ScalarType.h"

#include <glm/glm.hpp>

#include <string>

/// \file
/// Functions that write MixingLayer in the formats of volumes, slab by slab.

/// A volume to be written.
struct VolumeOrder
{
  std::string Path;
  glm::ivec3 Dimensions{ 0 };
  TemporalCoherence::ScalarType Type = TemporalCoherence::ScalarType::UInt8;
  std::string Codec; ///< the compression; empty: the format's default
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

#endif
